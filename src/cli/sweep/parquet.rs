//! A sweep as a Parquet file.

use std::fs::File;
use std::io;
use std::path::Path;
use std::sync::Arc;

use bytes::Bytes;
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::column::writer::ColumnCloseResult;
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType};
use parquet::errors::ParquetError;
use parquet::file::metadata::RowGroupMetaData;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::record::Field;
use parquet::schema::types::{Type, TypePtr};
use tempfile::NamedTempFile;

use crate::cli::Outcome;
use crate::cli::folder::staged;
use crate::cli::output::wrong;
use crate::cli::partial::{Left, Reserved};
use crate::report::columns::{Cells, Column};

use super::rows::{Table, compute};
use super::written::{FOLDER, ended, told, unwritable};

/// About so many points are in a row group.
const GROUP: u64 = 1 << 18;

/// Computes a table and writes it as columns.
///
/// Row groups are written to a file that gets the name of the target when all rows are there. If the user interrupts,
/// it becomes the file of the rows that are left, which has an end as any other one: the next run copies its groups.
pub(super) fn to_columns(
    table: &dyn Table,
    path: &Path,
    identity: &str,
) -> Result<Outcome, Outcome> {
    if path.exists() && !path.is_file() {
        let what = format!(
            "`{}` is no regular file: Parquet is not written row by row",
            path.display()
        );
        let help = "name a file, or a pipe whose name does not end in .parquet";
        return Err(wrong(&what, help));
    }
    let cannot_begin = |error: &io::Error| unwritable(path, error, FOLDER);
    let reserved = Reserved::new(path, identity).map_err(|error| cannot_begin(&error))?;
    let mut groups = Groups::new(&reserved, table).map_err(|error| cannot_begin(&error))?;
    let left = groups
        .take_over(&reserved, table)
        .map_err(|error| cannot_begin(&error))?;
    let done = told(Some(&reserved), left);
    let write = |parts: Vec<Vec<Column>>| groups.write(&parts).map(|()| true);
    let computed = compute(table, done, GROUP, |columns| columns, write);
    let written = match computed {
        Ok(()) => groups.end().and_then(|file| reserved.finish(file)),
        Err(error) if error.kind() == io::ErrorKind::Interrupted => groups
            .end()
            .and_then(|file| reserved.leave(file))
            .and(Err(error)),
        Err(error) => Err(error),
    };
    ended(table, path, written)
}

/// Row groups on their way to a file.
struct Groups {
    writer: SerializedFileWriter<NamedTempFile>,
}

impl Groups {
    fn new(reserved: &Reserved, table: &dyn Table) -> io::Result<Self> {
        // Results hardly repeat: a dictionary of them costs time and saves nothing. Groups are small enough to be read
        // whole, and one that is copied has no index of its pages.
        let mut properties = WriterProperties::builder()
            .set_dictionary_enabled(false)
            .set_statistics_enabled(EnabledStatistics::Chunk)
            .set_offset_index_disabled(true);
        let columns = table.columns(0..0);
        for own in columns.iter().filter(|own| is_words(&own.cells)) {
            properties = properties.set_column_dictionary_enabled(own.name.as_str().into(), true);
        }
        let file = staged(reserved.folder())?;
        let writer = SerializedFileWriter::new(file, schema(&columns)?, properties.build().into())?;
        Ok(Groups { writer })
    }

    /// Copies the groups of an earlier run, if its last row is the one that is to stand there.
    fn take_over(&mut self, reserved: &Reserved, table: &dyn Table) -> io::Result<Left> {
        let Ok(earlier) = SerializedFileReader::new(reserved.file().try_clone()?) else {
            return Ok(Left::Nothing);
        };
        let groups = earlier.metadata().row_groups();
        let rows: i64 = groups.iter().map(RowGroupMetaData::num_rows).sum();
        let rows = u64::try_from(rows).unwrap_or(0);
        if rows == 0 {
            return Ok(Left::Nothing);
        }
        let expected = (rows <= table.count()).then(|| table.columns(rows - 1..rows));
        if last_row(&earlier)? != expected.map(|own| fields(&own)) {
            return Ok(Left::Useless(rows));
        }
        for group in groups {
            self.copy(reserved.file(), group)?;
        }
        Ok(Left::Rows(rows))
    }

    fn copy(&mut self, earlier: &File, group: &RowGroupMetaData) -> io::Result<()> {
        let mut columns = self.writer.next_row_group()?;
        for own in group.columns() {
            let chunk = ColumnCloseResult {
                bytes_written: own.compressed_size().unsigned_abs(),
                rows_written: group.num_rows().unsigned_abs(),
                metadata: own.clone(),
                bloom_filter: None,
                column_index: None,
                offset_index: None,
            };
            columns.append_column(earlier, chunk)?;
        }
        columns.close()?;
        Ok(())
    }

    /// Adds a group of rows, which are given part by part.
    fn write(&mut self, parts: &[Vec<Column>]) -> io::Result<()> {
        let mut columns = self.writer.next_row_group()?;
        let mut place = 0;
        while let Some(mut column) = columns.next_column()? {
            for part in parts {
                write_cells(&mut column, &part[place].cells)?;
            }
            column.close()?;
            place += 1;
        }
        columns.close()?;
        Ok(())
    }

    /// The file, whole.
    fn end(self) -> io::Result<NamedTempFile> {
        Ok(self.writer.into_inner()?)
    }
}

fn is_words(cells: &Cells) -> bool {
    matches!(cells, Cells::Words(_))
}

/// Columns of doubles and words, each of which may be missing.
fn schema(columns: &[Column]) -> Result<TypePtr, ParquetError> {
    let column = |own: &Column| {
        let builder = match is_words(&own.cells) {
            true => Type::primitive_type_builder(&own.name, Physical::BYTE_ARRAY)
                .with_logical_type(Some(LogicalType::String)),
            false => Type::primitive_type_builder(&own.name, Physical::DOUBLE),
        };
        let column = builder.with_repetition(Repetition::OPTIONAL).build();
        column.map(Arc::new)
    };
    let columns = columns.iter().map(column).collect::<Result<_, _>>()?;
    let schema = Type::group_type_builder("sweep")
        .with_fields(columns)
        .build()?;
    Ok(Arc::new(schema))
}

fn write_cells(column: &mut SerializedColumnWriter<'_>, cells: &Cells) -> Result<(), ParquetError> {
    if let Cells::Words(words) = cells {
        let levels: Vec<i16> = words.iter().map(|own| i16::from(!own.is_empty())).collect();
        // Bytes that do not change are not copied.
        let words = words.iter().filter(|own| !own.is_empty());
        let words: Vec<ByteArray> = words
            .map(|own| Bytes::from_static(own.as_bytes()).into())
            .collect();
        let column = column.typed::<ByteArrayType>();
        return column.write_batch(&words, Some(&levels), None).map(|_| ());
    }
    let mut numbers = cells.numbers();
    let levels: Vec<i16> = numbers.iter().map(|own| i16::from(!own.is_nan())).collect();
    numbers.retain(|own| !own.is_nan());
    let column = column.typed::<DoubleType>();
    column
        .write_batch(&numbers, Some(&levels), None)
        .map(|_| ())
}

/// The last row of a file.
fn last_row(file: &SerializedFileReader<File>) -> io::Result<Option<Vec<Field>>> {
    let last = file.num_row_groups().saturating_sub(1);
    let group = file.get_row_group(last)?;
    let row = group.get_row_iter(None)?.last().transpose()?;
    let fields = |own: parquet::record::Row| own.into_columns();
    Ok(row.map(|row| fields(row).into_iter().map(|(_, field)| field).collect()))
}

/// The first row of columns.
fn fields(columns: &[Column]) -> Vec<Field> {
    let field = |own: &Column| match &own.cells {
        Cells::Words(words) if words[0].is_empty() => Field::Null,
        Cells::Words(words) => Field::Str(words[0].to_string()),
        cells => match cells.numbers()[0] {
            own if own.is_nan() => Field::Null,
            own => Field::Double(own),
        },
    };
    columns.iter().map(field).collect()
}
