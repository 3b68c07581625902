<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Ldem\Resolution;

/** The tables, as docs/database.md describes them. Every statement is valid for MariaDB 10.5 and MySQL 8.0. */
final class Schema
{
    /** Changes with the meaning of a column; a table of another version is refused. */
    public const FORMAT_VERSION = 1;

    public const IMPORTS = 'ldem_import';

    // Numbers of lines and samples: 368640 at 1024 px/deg.
    // SRID 0, the plane: without this attribute MySQL 8 never uses the spatial index; MariaDB skips the comment.
    private const ELEVATION_COLUMNS = <<<'SQL'
        row_index MEDIUMINT UNSIGNED NOT NULL,
        col_index MEDIUMINT UNSIGNED NOT NULL,
        latitude DOUBLE NOT NULL,
        longitude DOUBLE NOT NULL,
        planetary_radius DOUBLE NOT NULL,
        x DOUBLE NOT NULL,
        y DOUBLE NOT NULL,
        z DOUBLE NOT NULL,
        `point` POINT NOT NULL /*!80003 SRID 0 */,
        PRIMARY KEY (row_index, col_index),
        SPATIAL KEY point_index (`point`)
        SQL;

    private const IMPORT_COLUMNS = <<<'SQL'
        table_name VARCHAR(16) NOT NULL,
        product_id VARCHAR(40) NOT NULL,
        state VARCHAR(10) NOT NULL,
        format_version SMALLINT UNSIGNED NOT NULL,
        label_sha256 CHAR(64) NOT NULL,
        image_sha256 CHAR(64) NOT NULL,
        image_bytes BIGINT UNSIGNED NOT NULL,
        first_row MEDIUMINT UNSIGNED NOT NULL,
        row_count MEDIUMINT UNSIGNED NOT NULL,
        first_col MEDIUMINT UNSIGNED NOT NULL,
        col_count MEDIUMINT UNSIGNED NOT NULL,
        rows_done MEDIUMINT UNSIGNED NOT NULL,
        PRIMARY KEY (table_name, product_id)
        SQL;

    public function __construct(private readonly Connection $connection)
    {
    }

    /** The table that says what was imported; stays as it is if it is there. */
    public function createImports(): void
    {
        $this->connection->execute('CREATE TABLE IF NOT EXISTS ' . self::IMPORTS . ' (' . self::IMPORT_COLUMNS
            . ') ENGINE=InnoDB DEFAULT CHARSET=ascii COLLATE=ascii_bin');
    }

    /** The table of a resolution; stays as it is if it is there. */
    public function createElevations(Resolution $resolution): void
    {
        $this->connection->execute("CREATE TABLE IF NOT EXISTS {$resolution->table()} (" . self::ELEVATION_COLUMNS . ') ENGINE=InnoDB');
    }

    public function dropElevations(Resolution $resolution): void
    {
        $this->connection->execute("DROP TABLE IF EXISTS {$resolution->table()}");
    }

    public function exists(string $table): bool
    {
        return $this->connection->value(
            'SELECT COUNT(*) FROM information_schema.tables WHERE table_schema = DATABASE() AND table_name = ?',
            [$table]
        ) > 0;
    }

    /** @throws BadInputException a column of the table is missing, or of another type than was made here */
    public function requireColumns(Resolution $resolution): void
    {
        $types = array_column($this->connection->rows(
            'SELECT column_name AS name, CONCAT(data_type, IF(is_nullable = \'YES\', \' or NULL\', \'\')) AS type'
            . ' FROM information_schema.columns WHERE table_schema = DATABASE() AND table_name = ?',
            [$resolution->table()]
        ), 'type', 'name');
        preg_match_all('/^`?(\w+)`? ([A-Z]+).* NOT NULL/m', self::ELEVATION_COLUMNS, $columns, PREG_SET_ORDER);
        foreach ($columns as [, $name, $type]) {
            $expected = strtolower($type);
            $found = isset($types[$name]) ? strtolower($types[$name]) : null;
            if ($found !== $expected) {
                throw new BadInputException("{$resolution->table()} is damaged: " . ($found === null
                    ? "it has no column $name"
                    : "its column $name is of the type '" . str_replace('null', 'NULL', $found) . "', '$expected' expected")
                    . '. Drop it, and import its products again.');
            }
        }
    }

    /** @throws BadInputException there is a table of this name that was not made here */
    public function requireOwn(Resolution $resolution): void
    {
        $keys = $this->connection->rows(
            'SELECT CONCAT_WS(\' \', index_name, seq_in_index, column_name) AS entry FROM information_schema.statistics'
            . ' WHERE table_schema = DATABASE() AND table_name = ?',
            [$resolution->table()]
        );
        $entries = array_column($keys, 'entry');
        sort($entries);
        if ($entries !== ['PRIMARY 1 row_index', 'PRIMARY 2 col_index', 'point_index 1 point']) {
            throw new BadInputException(
                "database {$this->connection->database}: the table {$resolution->table()} there has other keys than "
                . 'this version makes (docs/database.md). Rename or drop it, or import into another database.',
            );
        }
    }
}
