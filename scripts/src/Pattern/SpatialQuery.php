<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Msisf\Scripts\Database\Connection;
use Msisf\Scripts\Ldem\Resolution;
use PDO;

/** Reads samples by the spatial index, as the thesis does: those whose points lie in a polygon. */
final class SpatialQuery implements SampleQuery
{
    public function __construct(private readonly Connection $connection, private readonly Resolution $resolution)
    {
    }

    public function radii(int $line, int $lines, int $sample, int $samples): array
    {
        $table = $this->resolution->table();
        // The samples come in the order of the index: each brings its place along. Sorting here is faster than ORDER BY.
        $sql = 'SELECT (row_index - ?) * ? + (col_index - ?), planetary_radius'
            . " FROM $table WHERE MBRContains(ST_GeomFromText(?), point)";
        $values = [$line, $samples, $sample, $this->polygon($line, $lines, $sample, $samples)];
        $radii = SampleReader::fetch($this->connection, $sql, $values, PDO::FETCH_KEY_PAIR);
        ksort($radii);

        return array_values($radii);
    }

    /** The rectangle half a step round the samples: its borders hold no sample, so it does not matter if they belong to it. */
    private function polygon(int $line, int $lines, int $sample, int $samples): string
    {
        $step = 1.0 / $this->resolution->value;
        $west = $sample * $step;
        $east = ($sample + $samples) * $step;
        $north = 90.0 - $line * $step;
        $south = 90.0 - ($line + $lines) * $step;

        return "POLYGON(($west $south, $east $south, $east $north, $west $north, $west $south))";
    }
}
