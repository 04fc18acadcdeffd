//! Binds the evaluators that come with the program: their names, units and functions are read off their text, so that
//! what is emitted is the only place where they stand.

use std::fmt::Write;
use std::path::Path;
use std::{env, fs, io};

use quote::ToTokens;
use syn::{Attribute, Expr, Fields, Item, ItemFn, ItemImpl, ItemStruct, Member, Stmt};

/// Where the evaluators stand.
const EVALUATORS: &str = "../codegen/evaluators/src";

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed={EVALUATORS}");
    let mut paths: Vec<_> = fs::read_dir(EVALUATORS)?
        .map(|entry| entry.map(|own| own.path()))
        .collect::<Result<_, _>>()?;
    paths.sort();
    let mut bound = String::from("pub static SHIPPED: &[Shipped] = &[\n");
    for path in paths {
        bound += &bind(&path)?.unwrap_or_default();
    }
    bound += "];\n";
    let out = env::var("OUT_DIR").map_err(io::Error::other)?;
    fs::write(Path::new(&out).join("shipped.rs"), bound)
}

/// The entry of an evaluator; nothing for a file that holds something else.
fn bind(path: &Path) -> io::Result<Option<String>> {
    let text = fs::read_to_string(path)?;
    let file = syn::parse_file(&text).map_err(io::Error::other)?;
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    Ok(Evaluator::of(&stem, &file.items).map(|own| own.entry()))
}

/// A quantity and what is said of it.
struct Quantity {
    name: String,
    text: String,
}

/// What an emitted file holds.
struct Evaluator<'f> {
    name: String,
    /// The beginning of the names of its types.
    kind: String,
    text: String,
    inputs: Vec<Quantity>,
    /// Where angles stand for their sines and cosines: what is asked then, and what is made of it.
    angles: Option<(Vec<Quantity>, &'f ItemImpl)>,
    outputs: Vec<Quantity>,
}

impl<'f> Evaluator<'f> {
    fn of(name: &str, items: &'f [Item]) -> Option<Self> {
        let function = items.iter().find_map(|item| match item {
            Item::Fn(function) if function.sig.ident == name => Some(function),
            _ => None,
        })?;
        let body = format!("{name}_body");
        let is_body = |item: &Item| matches!(item, Item::Fn(own) if own.sig.ident == body);
        items.iter().find(|item| is_body(item))?;
        let structure = |ending: &str| items.iter().find_map(|item| structure(item, ending));
        let (inputs, outputs) = (structure("Inputs")?, structure("Outputs")?);
        let conversion = items.iter().find_map(|item| match item {
            Item::Impl(own) if conversion(own) => Some(own),
            _ => None,
        });
        let angles = structure("Angles").and_then(|own| Some((quantities(own), conversion?)));
        Some(Evaluator {
            name: name.to_string(),
            kind: inputs.ident.to_string().trim_end_matches("Inputs").into(),
            text: documentation_of(function),
            inputs: quantities(inputs),
            angles,
            outputs: quantities(outputs),
        })
    }

    /// What a user is asked for, with what is said of it.
    fn asked(&self) -> Vec<(&str, &str)> {
        let Some((angles, _)) = &self.angles else {
            return pairs(&self.inputs);
        };
        let said = |own: &Quantity| self.inputs.iter().find(|input| input.name == own.name);
        let text = |own| said(own).map_or_else(|| own.text.as_str(), |input| &input.text);
        let asked = angles.iter();
        asked.map(|own| (own.name.as_str(), text(own))).collect()
    }

    /// Where the inputs come from, in Rust.
    fn sources(&self) -> String {
        let asked = self.asked();
        let place = |name: &str| asked.iter().position(|(own, _)| *own == name);
        let mut sources = String::new();
        for input in &self.inputs {
            let made = || {
                self.angles
                    .as_ref()
                    .and_then(|(_, own)| made(own, &input.name))
            };
            let _ = match (place(&input.name), made()) {
                (Some(place), _) => write!(sources, "Origin::Given({place}), "),
                (None, Some(made)) => write!(sources, "{}, ", circular(&made, &asked)),
                (None, None) => Ok(()),
            };
        }
        sources
    }

    fn entry(&self) -> String {
        let (name, kind) = (&self.name, &self.kind);
        let taken = |ending: &str| {
            let inputs = self.inputs.iter().enumerate();
            let one = inputs.map(|(place, own)| format!("{}: i[{place}]{ending}", own.name));
            one.collect::<Vec<_>>().join(", ")
        };
        let outputs: Vec<&str> = self.outputs.iter().map(|own| own.name.as_str()).collect();
        let given = outputs.iter().map(|own| format!("{own}: &mut **{own}"));
        let bounded = outputs.iter().map(|own| format!("found.{own}"));
        format!(
            "Shipped {{ name: {name:?}, text: {:?}, asked: &{:?}, origins: &[{}], outputs: &{:?},\n\
             batch: |i, o| match o {{ [{}] => {name}::{name}_batch(&{name}::{kind}Inputs {{ {} }}, \
             &mut {name}::{kind}Outputs {{ {} }}, Mode::Strict).is_ok(), _ => false }},\n\
             bounded: |i| {{ let found = {name}::{name}_with_bound(&{name}::{kind}Inputs {{ {} }}); \
             vec![{}] }} }},\n",
            self.text,
            self.asked(),
            self.sources(),
            pairs(&self.outputs),
            outputs.join(", "),
            taken(""),
            given.collect::<Vec<_>>().join(", "),
            taken(""),
            bounded.collect::<Vec<_>>().join(", "),
        )
    }
}

fn pairs(quantities: &[Quantity]) -> Vec<(&str, &str)> {
    let all = quantities.iter();
    all.map(|own| (own.name.as_str(), own.text.as_str()))
        .collect()
}

fn structure<'f>(item: &'f Item, ending: &str) -> Option<&'f ItemStruct> {
    match item {
        Item::Struct(own) if own.ident.to_string().ends_with(ending) => Some(own),
        _ => None,
    }
}

fn quantities(structure: &ItemStruct) -> Vec<Quantity> {
    let Fields::Named(fields) = &structure.fields else {
        return Vec::new();
    };
    let fields = fields.named.iter().filter_map(|field| {
        Some(Quantity {
            name: field.ident.as_ref()?.to_string(),
            text: documentation(&field.attrs)
                .trim_end_matches('.')
                .to_string(),
        })
    });
    fields.collect()
}

/// Whether angles become inputs.
fn conversion(own: &ItemImpl) -> bool {
    let name = own.trait_.as_ref().map(|(_, path, _)| path);
    let last = name.and_then(|path| path.segments.last());
    last.is_some_and(|own| own.ident == "From")
}

/// What an input is made of: `(alpha_g + theta_0).cos()`.
fn made(conversion: &ItemImpl, input: &str) -> Option<Expr> {
    let syn::ImplItem::Fn(function) = conversion.items.first()? else {
        return None;
    };
    let Some(Stmt::Expr(Expr::Struct(made), None)) = function.block.stmts.last() else {
        return None;
    };
    let is_it = |member: &Member| matches!(member, Member::Named(own) if own == input);
    let mut fields = made.fields.iter();
    fields
        .find(|field| is_it(&field.member))
        .map(|field| field.expr.clone())
}

/// The expression of a sine or cosine as a function of what is asked for.
fn circular(made: &Expr, asked: &[(&str, &str)]) -> String {
    let text = made.to_token_stream().to_string();
    let words: Vec<&str> = text
        .split(|own: char| !own.is_alphanumeric() && own != '_')
        .collect();
    let (mut of, mut names) = (Vec::new(), String::new());
    for (place, (name, _)) in asked.iter().enumerate() {
        if words.contains(name) {
            of.push(place);
            let _ = write!(names, "let {name} = a[{place}]; ");
        }
    }
    format!("Origin::Made(&{of:?}, |a| {{ {names}{text} }})")
}

fn documentation_of(function: &ItemFn) -> String {
    documentation(&function.attrs)
}

/// The lines of documentation, as text.
fn documentation(attributes: &[Attribute]) -> String {
    let lines = attributes.iter().filter_map(|own| match &own.meta {
        syn::Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
            Expr::Lit(own) => match &own.lit {
                syn::Lit::Str(text) => Some(text.value()),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    });
    let lines: Vec<String> = lines.map(|own| own.trim().replace('\\', "")).collect();
    lines.join("\n")
}
