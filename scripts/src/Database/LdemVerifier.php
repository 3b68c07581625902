<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use LogicException;
use Msisf\Scripts\Console\Output;
use Msisf\Scripts\Console\Progress;
use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Ldem\LdemImage;
use Msisf\Scripts\Ldem\Resolution;
use Msisf\Scripts\Pattern\GridDirections;
use PDO;
use PDOStatement;

/** Compares every row of a product in its table with the file: each column, bit for bit. */
final class LdemVerifier
{
    public function __construct(private readonly Connection $connection, private readonly Output $output)
    {
    }

    /**
     * @return string SHA-256 over the rows of the product, line by line: the line's coordinates and radii, docs/database.md
     * @throws BadInputException the product is not there, or not as the file has it
     */
    public function verify(LdemImage $image): string
    {
        $resolution = Resolution::of($image->label->pixelsPerDegree);
        $record = $this->recordOf($image, $resolution);
        $schema = new Schema($this->connection);
        if ($schema->exists($resolution->table())) {
            $schema->requireColumns($resolution);
        }
        $directions = new GridDirections($resolution->value);
        $columns = self::columns($directions, $resolution, $record);
        $hash = hash_init('sha256');
        $progress = new Progress($this->output, 'rows compared', $record->rowCount * $record->columnCount);
        $select = $this->connection->wrap(fn (): PDOStatement => $this->connection->pdo()->prepare(
            'SELECT row_index, col_index, latitude, longitude, planetary_radius, x, y, z, `point`'
            . " FROM {$resolution->table()} WHERE row_index = ? AND col_index >= ? AND col_index < ? ORDER BY row_index, col_index"
        ));
        foreach ($image->lines() as $line => $values) {
            $row = $record->firstRow + $line;
            $expected = self::expectedLine($image, $resolution, $directions, $columns, $row, $values);
            $found = $this->connection->wrap(static fn (): array => self::fetchLine($select, $row, $record));
            if ($found !== $expected) {
                throw $this->difference($found, $expected, $resolution, $row, $record);
            }
            hash_update($hash, self::bytes($expected));
            $progress->reach(($line + 1) * $record->columnCount);
        }
        $progress->finish();
        $this->checkCount($resolution);

        return hash_final($hash);
    }

    private function recordOf(LdemImage $image, Resolution $resolution): ImportRecord
    {
        $table = $resolution->table();
        $wanted = ProductRecord::of($image, $resolution);
        $records = (new Schema($this->connection))->exists(Schema::IMPORTS) ? (new ImportRecords($this->connection))->of($resolution) : [];
        foreach ($records as $record) {
            if ($record->productId === $wanted->productId) {
                if ($record->state !== ImportState::Complete) {
                    throw new BadInputException("$table: $record->rowsDone of $record->rowCount lines of $wanted->productId are imported."
                        . ' Run the import again: it goes on where it stopped.');
                }

                return $record->isOfSameFiles($wanted) ? $record : throw new BadInputException(
                    "$wanted->productId: label or image is not the one that was imported into $table. Import it with --replace."
                );
            }
        }
        throw new BadInputException("$wanted->productId is not in $table of the database {$this->connection->database}. Import it first.");
    }

    /**
     * @return list<array{int, float, float, float, string}> column, longitude, its sine and cosine, the point's bytes before the
     *     latitude
     */
    private static function columns(GridDirections $directions, Resolution $resolution, ImportRecord $record): array
    {
        $columns = [];
        for ($column = $record->firstColumn; $column < $record->firstColumn + $record->columnCount; $column++) {
            $longitude = (2 * $column + 1) / (2.0 * $resolution->value);
            // The server's form of a point: SRID 0, then well-known binary: little-endian, type 1.
            $columns[] = [$column, $longitude, ...$directions->longitude($column), pack('VCVe', 0, 1, 1, $longitude)];
        }

        return $columns;
    }

    /**
     * @param list<array{int, float, float, float, string}> $columns
     * @param list<int|float> $values
     * @return list<list<int|float|string>>
     */
    private static function expectedLine(
        LdemImage $image,
        Resolution $resolution,
        GridDirections $directions,
        array $columns,
        int $row,
        array $values,
    ): array {
        $latitude = 90.0 - (2 * $row + 1) / (2.0 * $resolution->value);
        [$sine, $cosine] = $directions->latitude($row);
        $pointEnd = pack('e', $latitude);
        $line = [];
        foreach ($columns as $i => [$column, $longitude, $longitudeSine, $longitudeCosine, $pointStart]) {
            $radius = $image->radius($values[$i]);
            $equatorial = $radius * $cosine;
            $line[] = [
                $row, $column, $latitude, $longitude, $radius,
                $equatorial * $longitudeCosine, $equatorial * $longitudeSine, $radius * $sine, $pointStart . $pointEnd,
            ];
        }

        return $line;
    }

    /** @return list<list<int|float|string>> */
    private static function fetchLine(PDOStatement $select, int $row, ImportRecord $record): array
    {
        Statement::bind($select, [$row, $record->firstColumn, $record->firstColumn + $record->columnCount]);
        $select->execute();

        return $select->fetchAll(PDO::FETCH_NUM);
    }

    /** @param list<list<int|float|string>> $line */
    private static function bytes(array $line): string
    {
        $bytes = '';
        for ($field = 2; $field < 8; $field++) {
            $bytes .= pack('e*', ...array_column($line, $field));
        }

        return $bytes;
    }

    /**
     * @param list<list<int|float|string>> $found
     * @param list<list<int|float|string>> $expected
     */
    private function difference(array $found, array $expected, Resolution $resolution, int $row, ImportRecord $record): BadInputException
    {
        $table = $resolution->table();
        if (count($found) !== count($expected)) {
            return new BadInputException("$table, row_index $row: " . count($found) . " rows of $record->productId, " . count($expected)
                . ' expected. Something has changed the table: import it again with --replace.');
        }
        $names = ['row_index', 'col_index', 'latitude', 'longitude', 'planetary_radius', 'x', 'y', 'z', 'point'];
        foreach ($expected as $i => $fields) {
            foreach ($fields as $field => $value) {
                if ($found[$i][$field] !== $value) {
                    [$is, $should] = $field === 8 ? [bin2hex((string) $found[$i][8]), bin2hex($value)] : [$found[$i][$field], $value];

                    return new BadInputException("$table, row_index $row, col_index $fields[1]: $names[$field] is $is, $should expected"
                        . ' by the file. Import it again with --replace.');
                }
            }
        }

        throw new LogicException('The lines do not differ.');
    }

    /** @throws BadInputException a row belongs to no product */
    private function checkCount(Resolution $resolution): void
    {
        $expected = 0;
        foreach ((new ImportRecords($this->connection))->of($resolution) as $record) {
            if ($record->state === ImportState::Removing) {
                return;
            }
            $expected += $record->samplesDone();
        }
        $found = $this->connection->value("SELECT COUNT(*) FROM {$resolution->table()}");
        if ($found !== $expected) {
            throw new BadInputException("{$resolution->table()}: $found rows, $expected expected by " . Schema::IMPORTS . '.');
        }
    }
}
