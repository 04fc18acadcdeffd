//! x
use sextic_codegen::language::{Language, emit};
#[test]
fn writes() {
    for l in Language::ALL {
        for file in emit(&super::samples::all(), l).unwrap() {
            let path = std::path::Path::new("/tmp/printers/target/probe/")
                .join(l.name())
                .join("src")
                .join(&file.path);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, file.text).unwrap();
        }
    }
}
