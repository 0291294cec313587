//! What is printed of a wire, looked at from outside.

mod files;
mod jig;
mod solid;
mod support;
