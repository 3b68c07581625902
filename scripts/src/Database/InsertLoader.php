<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

/** INSERT statements of many rows, for servers that do not allow LOAD DATA LOCAL. */
final class InsertLoader implements RadiusLoader
{
    /** Rows a statement: about 150 kB, below the smallest default of max_allowed_packet (1 MB). Longer ones are not faster. */
    private const ROWS = 5000;

    public function __construct(private readonly Connection $connection)
    {
    }

    public function name(): string
    {
        return 'INSERT of ' . self::ROWS . ' rows';
    }

    public function load(array $rows): void
    {
        foreach (array_chunk($rows, self::ROWS) as $chunk) {
            // Digits, signs, points and E only: RowText makes them of numbers.
            $values = str_replace("\t", ',', implode('),(', $chunk));
            $this->connection->execute('INSERT INTO ' . GridTables::RADII . " (row_index, col_index, radius) VALUES ($values)");
        }
    }
}
