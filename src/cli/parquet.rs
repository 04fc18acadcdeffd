//! Rows as Parquet.

use std::fs::File;
use std::io;
use std::path::Path;
use std::sync::Arc;

use csv::{Reader, StringRecord};
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType};
use parquet::errors::ParquetError;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::{Type, TypePtr};

/// The columns of words; all others are of doubles.
const WORDS: [&str; 3] = ["mostly", "closed_limits", "uniform_limits"];

/// So many rows are in memory at once.
const GROUP: usize = 1 << 16;

/// Writes the rows of a CSV file to a Parquet file, in row groups; an empty cell becomes null.
pub fn from_csv(rows: &Path, file: &File) -> io::Result<()> {
    let mut rows = Reader::from_path(rows)?;
    let names = rows.headers()?.clone();
    let mut writer = SerializedFileWriter::new(file, schema(&names)?, Arc::default())?;
    let mut records = rows.records();
    loop {
        let group = records
            .by_ref()
            .take(GROUP)
            .collect::<Result<Vec<_>, _>>()?;
        if group.is_empty() {
            break;
        }
        let mut columns = writer.next_row_group()?;
        for (place, name) in names.iter().enumerate() {
            write_column(
                &mut columns,
                name,
                group.iter().map(|row| row.get(place).unwrap_or_default()),
            )?;
        }
        columns.close()?;
    }
    writer.close()?;
    Ok(())
}

fn schema(names: &StringRecord) -> Result<TypePtr, ParquetError> {
    let column = |name: &str| {
        let builder = match WORDS.contains(&name) {
            true => Type::primitive_type_builder(name, Physical::BYTE_ARRAY)
                .with_logical_type(Some(LogicalType::String)),
            false => Type::primitive_type_builder(name, Physical::DOUBLE),
        };
        builder
            .with_repetition(Repetition::OPTIONAL)
            .build()
            .map(Arc::new)
    };
    let columns = names.iter().map(column).collect::<Result<_, _>>()?;
    let schema = Type::group_type_builder("sweep")
        .with_fields(columns)
        .build()?;
    Ok(Arc::new(schema))
}

fn write_column<'a>(
    columns: &mut SerializedRowGroupWriter<'_, &File>,
    name: &str,
    cells: impl Iterator<Item = &'a str> + Clone,
) -> Result<(), ParquetError> {
    let missing = || ParquetError::General(format!("there is no column for {name}"));
    let mut column = columns.next_column()?.ok_or_else(missing)?;
    let levels: Vec<i16> = cells
        .clone()
        .map(|cell| i16::from(!cell.is_empty()))
        .collect();
    let present = cells.filter(|cell| !cell.is_empty());
    if WORDS.contains(&name) {
        let words: Vec<ByteArray> = present.map(ByteArray::from).collect();
        column
            .typed::<ByteArrayType>()
            .write_batch(&words, Some(&levels), None)?;
    } else {
        let number = |cell: &str| {
            let number = cell.parse::<f64>();
            number.map_err(|_| ParquetError::General(format!("`{cell}` in {name} is no number")))
        };
        let numbers = present.map(number).collect::<Result<Vec<f64>, _>>()?;
        column
            .typed::<DoubleType>()
            .write_batch(&numbers, Some(&levels), None)?;
    }
    column.close()
}
