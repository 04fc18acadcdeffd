//! The modes of a system that a document derives: `cargo run --example modes`.

use std::collections::BTreeMap;
use std::error::Error;

use sextic::algebra::number::Rational;
use sextic::compile::system::CompiledSystem;
use sextic::documents::ShippedLibrary;
use sextic::language::diagnostic::SourceFile;
use sextic::stability::system::System;
use sextic::verdict::audit::audit;

const DOCUMENT: &str = "# Two masses on springs

```sextic
parameter m : kg > 0
parameter k : N/m > 0
parameter c : kg/s
coordinate x, y : m
system (1) masses: mass m*identity(2) damping [c, 0; 0, 0] stiffness k*[2, -1; -1, 2] in x, y
```
";

fn main() -> Result<(), Box<dyn Error>> {
    let audit = audit(&SourceFile::new("masses.md", DOCUMENT), &ShippedLibrary)?;
    let stated = audit.systems[0].clone();
    let CompiledSystem {
        specification,
        coordinates,
        damping,
        stiffness,
    } = CompiledSystem::of(&stated, None, &audit)?;
    let system = System {
        evaluator: specification.evaluator,
        coordinates,
        damping,
        stiffness,
    };
    let values =
        [("m", 1), ("k", 4), ("c", 1)].map(|(name, own)| (name.to_string(), Rational::from(own)));
    let instance = system.at(&BTreeMap::from(values))?;
    for mode in instance.modes()? {
        let (value, error) = (mode.eigenvalue.value, mode.eigenvalue.error);
        println!("{value:.6} 1/s, within {error:.0e}");
    }
    println!("{}: {}", instance.verdict().name(), instance.verdict());
    Ok(())
}
