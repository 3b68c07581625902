<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Msisf\Scripts\Ldem\LdemLabel;
use Msisf\Scripts\Ldem\Resolution;
use Msisf\Scripts\Pattern\GridDirections;

/**
 * Temporary tables that live as long as the connection: sine and cosine of every line and column, correctly rounded in PHP
 * (a server's SIN and COS are its C library's), and the radii on their way to the server, which joins the three.
 */
final class GridTables
{
    public const RADII = 'msisf_radii';

    private const LINES = 'msisf_lines';

    private const SAMPLES = 'msisf_samples';

    /** Bytes: the radii of a band of lines take 44 MB at most (LDEM_256), the default limit is 16 MB. */
    private const MEMORY_LIMIT = 64 << 20;

    private const ROWS_PER_INSERT = 2000;

    private readonly GridDirections $directions;

    public function __construct(
        private readonly Connection $connection,
        private readonly Resolution $resolution,
        private readonly LdemLabel $label,
    ) {
        $this->directions = new GridDirections($resolution->value);
    }

    public function create(): void
    {
        $this->connection->execute('SET SESSION max_heap_table_size = ' . self::MEMORY_LIMIT);
        foreach (
            [
                self::RADII => 'row_index MEDIUMINT UNSIGNED NOT NULL, col_index MEDIUMINT UNSIGNED NOT NULL, radius DOUBLE NOT NULL',
                self::LINES => $this->directionColumns('row_index', 'latitude'),
                self::SAMPLES => $this->directionColumns('col_index', 'longitude'),
            ] as $table => $columns
        ) {
            $this->connection->execute("DROP TEMPORARY TABLE IF EXISTS $table");
            $this->connection->execute("CREATE TEMPORARY TABLE $table ($columns) ENGINE=MEMORY");
        }
        $this->fill(self::LINES, $this->label->firstLine(), $this->label->lines, fn (int $line): array => [
            90.0 - $this->halfStep($line),
            ...$this->directions->latitude($line),
        ]);
        $this->fill(self::SAMPLES, $this->label->firstSample(), $this->label->lineSamples, fn (int $sample): array => [
            $this->halfStep($sample),
            ...$this->directions->longitude($sample),
        ]);
    }

    public function clearRadii(): void
    {
        $this->connection->execute('TRUNCATE TABLE ' . self::RADII);
    }

    /**
     * Adds the rows of the loaded radii, in the order in which they were loaded. The products are in the order of the pattern
     * format: 128 x is, but for the rounding to whole steps, a vertex of the patterns, bit for bit.
     */
    public function insertElevations(): int
    {
        return $this->connection->execute("INSERT INTO {$this->resolution->table()}"
            . ' (row_index, col_index, latitude, longitude, planetary_radius, x, y, z, `point`)'
            . ' SELECT r.row_index, r.col_index, l.latitude, s.longitude, r.radius,'
            . ' (r.radius * l.cosine) * s.cosine, (r.radius * l.cosine) * s.sine, r.radius * l.sine, POINT(s.longitude, l.latitude)'
            . ' FROM ' . self::RADII . ' r'
            . ' STRAIGHT_JOIN ' . self::LINES . ' l ON l.row_index = r.row_index'
            . ' STRAIGHT_JOIN ' . self::SAMPLES . ' s ON s.col_index = r.col_index');
    }

    /** (2 index + 1) / (2 res) degrees: exact, as the resolutions are powers of two. */
    private function halfStep(int $index): float
    {
        return (2 * $index + 1) / (2.0 * $this->resolution->value);
    }

    private function directionColumns(string $index, string $angle): string
    {
        return "$index MEDIUMINT UNSIGNED NOT NULL PRIMARY KEY, $angle DOUBLE NOT NULL, sine DOUBLE NOT NULL, cosine DOUBLE NOT NULL";
    }

    /** @param callable(int): array{float, float, float} $numbersOf angle in degrees, sine, cosine */
    private function fill(string $table, int $first, int $count, callable $numbersOf): void
    {
        for ($start = $first; $start < $first + $count; $start += self::ROWS_PER_INSERT) {
            $rows = [];
            for ($index = $start; $index < min($start + self::ROWS_PER_INSERT, $first + $count); $index++) {
                // "e0": a literal without an exponent is a DECIMAL to the server.
                $numbers = array_map(static fn (float $number): string => sprintf('%.17e', $number), $numbersOf($index));
                $rows[] = "($index," . implode(',', $numbers) . ')';
            }
            $this->connection->execute("INSERT INTO $table VALUES " . implode(',', $rows));
        }
    }
}
