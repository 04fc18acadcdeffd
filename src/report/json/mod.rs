//! Verdicts and matchings for programs.
//!
//! Expressions are text in ASCII names with `**` for powers; nothing is shortened. What was computed is
//! read by SymPy; what the document says is in the block language.

mod audit;
#[cfg(feature = "stability")]
mod closeness;
mod evaluation;
mod ledger;
mod matching;
#[cfg(feature = "stability")]
mod modes;
#[cfg(feature = "stability")]
mod mutation;
mod pairs;
#[cfg(feature = "stability")]
mod ranges;
mod shown;
#[cfg(feature = "stability")]
mod speeds;
#[cfg(feature = "stability")]
mod stability;
#[cfg(feature = "stability")]
mod twist;
#[cfg(feature = "stability")]
mod validity;

use serde::Serialize;

use crate::language::notation::Notation;
use crate::language::syntax::Expression;

pub use audit::{audits, explanation};
#[cfg(feature = "stability")]
pub use closeness::closeness;
pub use evaluation::{evaluation, evaluators};
pub use ledger::ledger;
pub use matching::matchings;
#[cfg(feature = "stability")]
pub use modes::modes;
#[cfg(feature = "stability")]
pub use mutation::mutations;
#[cfg(feature = "stability")]
pub use ranges::ranges;
pub use shown::shown;
#[cfg(feature = "stability")]
pub use speeds::speeds;
#[cfg(feature = "stability")]
pub use stability::comparison;
#[cfg(feature = "stability")]
pub use validity::validity;

/// Indented JSON, ended by a line break.
fn write(document: &impl Serialize) -> String {
    // Only a map with keys other than text could fail, and there is none.
    serde_json::to_string_pretty(document).unwrap_or_default() + "\n"
}

/// An expression as Python reads it.
fn ascii(expression: &Expression) -> String {
    Notation::Ascii.expression(expression)
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::documents::ShippedLibrary;
    use crate::language::diagnostic::SourceFile;
    use crate::report::refusals::Messages;
    use crate::verdict::audit::{Audit, audit};

    const DOCUMENT: &str = "# Title

```sextic
parameter a, b, x : 1
claim (1): a/b == a/b
refute [wrong]: a == 2*a
match (2) matched: x^2 + a*x with x^2 + b*x in x unknown b at x
```
";

    fn audited() -> [Audit; 1] {
        let source = SourceFile::new("a.md", DOCUMENT);
        [audit(&source, &ShippedLibrary).expect("the document makes sense")]
    }

    fn read(text: &str) -> Value {
        serde_json::from_str(text).expect("what is written is JSON")
    }

    #[test]
    fn verdicts_have_the_documented_members() {
        let written = read(&super::audits(&audited(), &Messages::default()));
        let document = &written["documents"][0];
        assert_eq!(document["path"], "a.md");
        assert_eq!(document["title"], "Title");
        assert_eq!(document["as_expected"], true);
        assert_eq!(document["matchings"], json!(["2"]));
        let [first, second] = [&document["claims"][0], &document["claims"][1]];
        assert_eq!(first["id"], "1");
        assert_eq!(first["equation"], "1");
        assert_eq!(first["line"], 5);
        assert_eq!(first["statement"], "a/b == a/b");
        assert_eq!(first["expected"], "holds");
        assert_eq!(first["verdict"], "holds where");
        assert_eq!(first["conditions"], json!(["b != 0"]));
        assert_eq!(first["neglected"], json!([]));
        assert_eq!(first["residual"], Value::Null);
        assert_eq!(first["witness"], Value::Null);
        assert_eq!(second["equation"], Value::Null);
        assert_eq!(second["verdict"], "refuted");
        assert!(second["witness"]["point"]["a"].is_string());
        assert!(second["witness"]["left"].is_string());
    }

    #[test]
    fn matchings_have_the_documented_members() {
        let written = read(&super::matchings(&audited(), &Messages::default()));
        let matching = &written["matchings"][0];
        assert_eq!(matching["id"], "2");
        assert_eq!(matching["unknowns"], json!(["b"]));
        assert_eq!(matching["powers"], json!([1]));
        assert_eq!(matching["solution"], json!({"b": "a"}));
        assert_eq!(matching["singular_where"], json!([]));
        assert_eq!(matching["table"][0]["power"], 2);
        assert_eq!(matching["table"][1]["used"], true);
        assert_eq!(matching["table"][1]["residual"], "0");
    }
}
