//! Python
use super::{Error, File};
use crate::evaluator::Evaluator;
/// x
pub fn emit(_e: &[Evaluator]) -> Result<Vec<File>, Error> {
    todo!()
}
