<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Msisf\Scripts\Database\Connection;
use Msisf\Scripts\Ldem\Resolution;
use PDO;

/** Reads samples by ranges of the primary key (row, column), in which a line of samples lies together on the disk. */
final class GridQuery implements SampleQuery
{
    public function __construct(private readonly Connection $connection, private readonly Resolution $resolution)
    {
    }

    public function radii(int $line, int $lines, int $sample, int $samples): array
    {
        $table = $this->resolution->table();
        if ($samples === $this->resolution->lineSamples()) {
            // Whole lines are one range.
            $condition = 'row_index BETWEEN ? AND ?';
            $values = [$line, $line + $lines - 1];
        } else {
            // Of two BETWEENs only the first would limit what is read; a list of lines makes one range of each.
            $condition = 'row_index IN (' . implode(',', array_fill(0, $lines, '?')) . ') AND col_index BETWEEN ? AND ?';
            $values = [...range($line, $line + $lines - 1), $sample, $sample + $samples - 1];
        }
        $sql = "SELECT planetary_radius FROM $table FORCE INDEX (PRIMARY) WHERE $condition ORDER BY row_index, col_index";

        return SampleReader::fetch($this->connection, $sql, $values, PDO::FETCH_COLUMN);
    }
}
