fn main() {
    println!("wire4d xtask");
}
