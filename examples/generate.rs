//! Compiles a formula of a document to C and prints it: `cargo run --example generate`.

use std::error::Error;

use sextic::compile::generation::{Order, generate};
use sextic::documents::ShippedLibrary;
use sextic::language::diagnostic::SourceFile;
use sextic::verdict::audit::audit;
use sextic_codegen::language::Language;

const DOCUMENT: &str = "# Den Hartog

```sextic
parameter ρ : kg/m^3 > 0
parameter D : m > 0
parameter U : m/s > 0
parameter C_D, dC_L as slope : 1
evaluator (1) damping: c = ρ*D*U/2*(C_D + dC_L)
domain ρ = [1.1, 1.3], D = [0.01, 0.2], U = [1, 40], C_D = [0.2, 2], dC_L = [-10, 10]
```
";

fn main() -> Result<(), Box<dyn Error>> {
    let audit = audit(&SourceFile::new("den-hartog.md", DOCUMENT), &ShippedLibrary)?;
    let order = Order {
        points: 1000,
        ..Order::of_all(Language::C)
    };
    let generated = generate(&[audit], &order, &mut |_| {})?;
    for file in &generated.files {
        println!("/* {} */\n{}", file.path, file.text);
    }
    Ok(())
}
