use sextic::derivation::{audit::{Library, audit}, diagnostic::{SourceFile, render}, notation::Notation};
struct L;
impl Library for L { fn read(&self, path: &str, _: &str) -> Result<SourceFile, String> { std::fs::read_to_string(path).map(|t| SourceFile::new(path, t)).map_err(|e| e.to_string()) } }
fn main() {
    let path = std::env::args().nth(1).unwrap();
    let source = SourceFile::new(path.clone(), std::fs::read_to_string(&path).unwrap());
    let start = std::time::Instant::now();
    match audit(&source, &L) {
        Err(rejected) => for d in &rejected.diagnostics { print!("{}", render(d, &rejected.source, false)); },
        Ok(a) => {
            for c in &a.claims {
                println!("{} {:<24} {:<12} {}", if c.as_expected() {"ok "} else {"!!!"}, c.label.text, c.verdict.text(), Notation::Unicode.relation(&c.statement).chars().take(100).collect::<String>());
                for k in &c.conditions { println!("        where {} {:?}", Notation::Unicode.expression(&k.expression), k.requirement); }
                if let Some(r) = &c.reason { println!("        {r}"); }
                if let Some(r) = &c.residual { println!("        residual {}", Notation::Unicode.expression(r).chars().take(300).collect::<String>()); }
                if let Some(w) = &c.witness { println!("        {:?} {:?}: {} vs {}", w.point.iter().map(|(n,v)| format!("{n}={v}")).collect::<Vec<_>>(), w.entry, w.left, w.right); }
            }
            for m in &a.matchings {
                for (n, e) in &m.solution { println!("{n} = {}", Notation::Unicode.expression(e)); }
                println!("det {} singular {:?}", Notation::Unicode.expression(&m.determinant), m.singular_where.iter().map(|s| (Notation::Unicode.expression(&s.factor), s.finite)).collect::<Vec<_>>());
                for n in &m.neglected { println!("neglect {} at {} times {}", Notation::Unicode.expression(&n.expression), n.power, Notation::Unicode.expression(&n.factor)); }
                for r in &m.table { println!("{} used {} order {:?}\n   exact {}\n   assumed {}\n   residual {}", r.power, r.used, r.order, Notation::Ascii.expression(&r.exact).chars().take(200).collect::<String>(), Notation::Ascii.expression(&r.assumed).chars().take(200).collect::<String>(), Notation::Ascii.expression(&r.residual).chars().take(200).collect::<String>()); }
            }
        }
    }
    eprintln!("{:?}", start.elapsed());
}
