<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Msisf\Scripts\Ldem\Resolution;

/** The table ldem_import. */
final class ImportRecords
{
    private const COLUMNS = 'table_name, product_id, state, format_version, label_sha256, image_sha256, image_bytes,'
        . ' first_row, row_count, first_col, col_count, rows_done';

    public function __construct(private readonly Connection $connection)
    {
    }

    /** @return list<ImportRecord> all products of a resolution, also unfinished ones, from north-west to south-east */
    public function of(Resolution $resolution): array
    {
        $rows = $this->connection->rows(
            'SELECT ' . self::COLUMNS . ' FROM ' . Schema::IMPORTS . ' WHERE table_name = ? ORDER BY first_row, first_col, product_id',
            [$resolution->table()]
        );

        return array_map(static fn (array $row): ImportRecord => new ImportRecord(
            (string) $row['table_name'],
            (string) $row['product_id'],
            ImportState::from((string) $row['state']),
            (int) $row['format_version'],
            (string) $row['label_sha256'],
            (string) $row['image_sha256'],
            (int) $row['image_bytes'],
            (int) $row['first_row'],
            (int) $row['row_count'],
            (int) $row['first_col'],
            (int) $row['col_count'],
            (int) $row['rows_done'],
        ), $rows);
    }

    public function add(ImportRecord $record): void
    {
        $values = implode(', ', array_fill(0, 12, '?'));
        $this->connection->execute('INSERT INTO ' . Schema::IMPORTS . ' (' . self::COLUMNS . ") VALUES ($values)", [
            $record->table,
            $record->productId,
            $record->state->value,
            $record->formatVersion,
            $record->labelSha256,
            $record->imageSha256,
            $record->imageBytes,
            $record->firstRow,
            $record->rowCount,
            $record->firstColumn,
            $record->columnCount,
            $record->rowsDone,
        ]);
    }

    public function setRowsDone(ImportRecord $record, int $rowsDone): void
    {
        $this->connection->execute(
            'UPDATE ' . Schema::IMPORTS . ' SET rows_done = ? WHERE table_name = ? AND product_id = ?',
            [$rowsDone, $record->table, $record->productId]
        );
    }

    public function setState(ImportRecord $record, ImportState $state): void
    {
        $this->connection->execute(
            'UPDATE ' . Schema::IMPORTS . ' SET state = ? WHERE table_name = ? AND product_id = ?',
            [$state->value, $record->table, $record->productId]
        );
    }

    public function remove(ImportRecord $record): void
    {
        $this->connection->execute(
            'DELETE FROM ' . Schema::IMPORTS . ' WHERE table_name = ? AND product_id = ?',
            [$record->table, $record->productId]
        );
    }
}
