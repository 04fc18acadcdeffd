//! A sweep as a Parquet file.

use std::fs::File;
use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;

use bytes::Bytes;
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::column::writer::ColumnCloseResult;
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType};
use parquet::errors::ParquetError;
use parquet::file::metadata::{KeyValue, RowGroupMetaData};
use parquet::file::properties::{EnabledStatistics, WriterProperties, WriterPropertiesPtr};
use parquet::file::reader::{ChunkReader, FileReader, SerializedFileReader};
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::record::Field;
use parquet::schema::types::{ColumnPath, Type, TypePtr};
use tempfile::NamedTempFile;

use crate::cli::Outcome;
use crate::cli::folder::staged;
use crate::cli::output::wrong;
use crate::cli::partial::{Left, Reserved};
use crate::report::columns::{Cells, Column};

use super::messages::{AGAIN, FOLDER, ended, told, unwritable};
use super::rows::{Sizes, Table, compute};

/// Under this key a file has what tells its computation from others.
const IDENTITY: &str = "sextic";

/// A part becomes a row group.
fn groups_at_once() -> Sizes {
    Sizes {
        points: 1 << 16,
        fewest_rows: 1 << 12,
        parts: rayon::current_num_threads() as u64,
    }
}

/// What helps where nothing is left.
const ANEW: &str = "give the same command again: nothing is left of the rows that were computed";

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
    let format = Format::new(&table.columns(0..0), identity);
    let begun = format.and_then(|format| Ok((Groups::new(&reserved, &format)?, format)));
    let (mut groups, format) = begun.map_err(|error| cannot_begin(&error))?;
    let left = groups
        .take_over(&reserved, table)
        .map_err(|error| cannot_begin(&error))?;
    let done = told(Some(&reserved), left);
    let write = |parts: Vec<io::Result<Bytes>>| groups.add(parts).map(|()| true);
    let computed = compute(
        table,
        done,
        groups_at_once(),
        |parts| format.group(parts),
        write,
    );
    let are_there = groups.rows > 0;
    let (written, help) = match computed {
        Ok(()) => (groups.end().and_then(|file| reserved.finish(file)), ANEW),
        Err(error) if error.kind() == io::ErrorKind::Interrupted && are_there => {
            let left = groups.end().and_then(|file| reserved.leave(file));
            (left.and(Err(error)), AGAIN)
        }
        Err(error) => (Err(error), ANEW),
    };
    ended(table, path, written, help)
}

/// How columns are written.
struct Format {
    schema: TypePtr,
    properties: WriterPropertiesPtr,
}

impl Format {
    /// For columns like these, of a computation that is told from others.
    fn new(columns: &[Column], identity: &str) -> io::Result<Self> {
        let identity = KeyValue::new(IDENTITY.to_owned(), identity.to_owned());
        // Groups are small enough to be read whole, and one that is copied has no index of its pages.
        let mut properties = WriterProperties::builder()
            .set_dictionary_enabled(false)
            .set_statistics_enabled(EnabledStatistics::Chunk)
            .set_offset_index_disabled(true)
            .set_key_value_metadata(Some(vec![identity]));
        // Words and the values of axes repeat, and are numbered. Results hardly do.
        for own in columns {
            let path = || ColumnPath::from(own.name.as_str());
            if is_words(&own.cells) {
                properties =
                    properties.set_column_statistics_enabled(path(), EnabledStatistics::None);
            }
            let repeats = is_words(&own.cells) || own.is_full;
            properties = properties.set_column_dictionary_enabled(path(), repeats);
        }
        Ok(Format {
            schema: schema(columns)?,
            properties: properties.build().into(),
        })
    }

    fn writer<W: Write + Send>(&self, file: W) -> io::Result<SerializedFileWriter<W>> {
        let (schema, properties) = (self.schema.clone(), self.properties.clone());
        Ok(SerializedFileWriter::new(file, schema, properties)?)
    }

    /// A file with one group of rows, which are given as columns of some of them after the other.
    fn group(&self, parts: &[Vec<Column>]) -> io::Result<Bytes> {
        let mut writer = self.writer(Vec::new())?;
        let mut columns = writer.next_row_group()?;
        let mut place = 0;
        while let Some(mut column) = columns.next_column()? {
            for part in parts {
                write_cells(&mut column, &part[place])?;
            }
            column.close()?;
            place += 1;
        }
        columns.close()?;
        Ok(writer.into_inner()?.into())
    }
}

/// Row groups on their way to a file.
struct Groups {
    writer: SerializedFileWriter<NamedTempFile>,
    rows: i64,
}

impl Groups {
    fn new(reserved: &Reserved, format: &Format) -> io::Result<Self> {
        let writer = format.writer(staged(reserved.folder())?)?;
        Ok(Groups { writer, rows: 0 })
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
        // One that cannot be read is not as this program writes it.
        let last = last_row(&earlier).ok().flatten();
        if last != expected.map(|own| fields(&own)) {
            return Ok(Left::Useless(rows));
        }
        for group in groups {
            self.copy(reserved.file(), group)?;
        }
        Ok(Left::Rows(rows))
    }

    fn copy(&mut self, earlier: &impl ChunkReader, group: &RowGroupMetaData) -> io::Result<()> {
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
        self.rows += group.num_rows();
        Ok(())
    }

    /// Adds the groups of files.
    fn add(&mut self, files: Vec<io::Result<Bytes>>) -> io::Result<()> {
        for file in files {
            let file = file?;
            let reader = SerializedFileReader::new(file.clone())?;
            for group in reader.metadata().row_groups() {
                self.copy(&file, group)?;
            }
        }
        Ok(())
    }

    /// The file, whole.
    fn end(self) -> io::Result<NamedTempFile> {
        Ok(self.writer.into_inner()?)
    }
}

/// What stands where a computation is to be written.
pub(super) enum Standing {
    /// Nothing.
    Absent,
    /// All of its rows: a file gets its name only when it is whole.
    Whole,
    /// Something else.
    Other,
}

/// What stands at a path where a computation is to be written.
pub(super) fn standing(path: &Path, identity: &str) -> io::Result<Standing> {
    let file = match File::open(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Standing::Absent),
        other => other?,
    };
    let Ok(file) = SerializedFileReader::new(file) else {
        return Ok(Standing::Other);
    };
    let known = file.metadata().file_metadata().key_value_metadata();
    let is_own = |own: &KeyValue| own.key == IDENTITY && own.value.as_deref() == Some(identity);
    Ok(match known.is_some_and(|all| all.iter().any(is_own)) {
        true => Standing::Whole,
        false => Standing::Other,
    })
}

fn is_words(cells: &Cells) -> bool {
    matches!(cells, Cells::Words(_))
}

/// Columns of doubles and words.
fn schema(columns: &[Column]) -> Result<TypePtr, ParquetError> {
    let column = |own: &Column| {
        let builder = match is_words(&own.cells) {
            true => Type::primitive_type_builder(&own.name, Physical::BYTE_ARRAY)
                .with_logical_type(Some(LogicalType::String)),
            false => Type::primitive_type_builder(&own.name, Physical::DOUBLE),
        };
        let repetition = match own.is_full {
            true => Repetition::REQUIRED,
            false => Repetition::OPTIONAL,
        };
        builder.with_repetition(repetition).build().map(Arc::new)
    };
    let columns = columns.iter().map(column).collect::<Result<_, _>>()?;
    let schema = Type::group_type_builder("sweep")
        .with_fields(columns)
        .build()?;
    Ok(Arc::new(schema))
}

fn write_cells(
    writer: &mut SerializedColumnWriter<'_>,
    column: &Column,
) -> Result<(), ParquetError> {
    // Of a full column no level is written.
    let levels = |is_there: &mut dyn Iterator<Item = bool>| -> Option<Vec<i16>> {
        (!column.is_full).then(|| is_there.map(i16::from).collect())
    };
    if let Cells::Words(words) = &column.cells {
        let levels = levels(&mut words.iter().map(|own| !own.is_empty()));
        // Bytes that do not change are not copied.
        let words = words.iter().filter(|own| !own.is_empty());
        let words = words.map(|own| Bytes::from_static(own.as_bytes()).into());
        let writer = writer.typed::<ByteArrayType>();
        writer.write_batch(&words.collect::<Vec<ByteArray>>(), levels.as_deref(), None)?;
        return Ok(());
    }
    let mut numbers = column.cells.numbers();
    let levels = levels(&mut numbers.iter().map(|own| !own.is_nan()));
    numbers.retain(|own| !own.is_nan());
    let least = numbers.iter().copied().reduce(f64::min);
    let most = numbers.iter().copied().reduce(f64::max);
    let writer = writer.typed::<DoubleType>();
    let ends = (least.as_ref(), most.as_ref());
    writer.write_batch_with_statistics(&numbers, levels.as_deref(), None, ends.0, ends.1, None)?;
    Ok(())
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
