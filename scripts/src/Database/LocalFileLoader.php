<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

/** LOAD DATA LOCAL from memory: no file is written, whatever the disk is like. */
final class LocalFileLoader implements RadiusLoader
{
    public function __construct(private readonly Connection $connection)
    {
        MemoryStream::register();
    }

    public function name(): string
    {
        return 'LOAD DATA LOCAL';
    }

    public function load(array $rows): void
    {
        $address = MemoryStream::offer(implode("\n", $rows) . "\n");
        try {
            $this->connection->execute("LOAD DATA LOCAL INFILE '$address' INTO TABLE " . GridTables::RADII
                . ' CHARACTER SET binary (row_index, col_index, radius)');
        } finally {
            MemoryStream::withdraw();
        }
    }
}
