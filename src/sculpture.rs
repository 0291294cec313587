//! sculpture
