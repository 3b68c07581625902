<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Msisf\Scripts\Console\Output;
use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Ldem\Resolution;

/** Decides whether a product fits beside what is in its table, and deletes what is to be replaced. */
final class ImportRemoval
{
    private readonly ImportRecords $records;

    private readonly Schema $schema;

    public function __construct(private readonly Connection $connection, private readonly Output $output)
    {
        $this->records = new ImportRecords($connection);
        $this->schema = new Schema($connection);
    }

    /**
     * @return ImportRecord|null what is there of the same files, to go on with; null if nothing is
     * @throws BadInputException something else is there, and it is not to be replaced
     */
    public function makeRoom(ImportRecord $wanted, Resolution $resolution, bool $replace): ?ImportRecord
    {
        $present = $this->records->of($resolution);
        if (!$this->schema->exists($resolution->table())) {
            // Somebody has dropped it: what the records say is no longer so.
            array_map($this->records->remove(...), $present);

            return null;
        }
        if ($present === []) {
            throw new BadInputException(
                "database {$this->connection->database}: its table {$resolution->table()} was not made by this script. "
                . 'Rename or drop it, or import into another database.',
            );
        }
        $kept = null;
        foreach ($present as $record) {
            $isSameProduct = $record->productId === $wanted->productId;
            // A complete product is only replaced by itself to mend its table; one that is not goes on, also with --replace.
            $isToBeMended = $replace && $record->state === ImportState::Complete;
            if ($record->state === ImportState::Removing) {
                $this->remove($record, $resolution);
            } elseif ($isSameProduct && $record->isOfSameFiles($wanted) && !$isToBeMended) {
                $kept = $record;
            } elseif ($replace && ($isSameProduct || $record->overlaps($wanted))) {
                $this->remove($record, $resolution);
            } elseif ($isSameProduct) {
                throw new BadInputException("$wanted->productId: " . self::change($record, $wanted)
                    . ' since it was imported. Import it with --replace, or get the old files back.');
            } elseif ($record->overlaps($wanted)) {
                throw new BadInputException("$wanted->productId: {$resolution->table()} has $record->productId there already. "
                    . 'Give --replace to delete that, or import into another database.');
            }
        }

        return $kept;
    }

    /** May be interrupted anywhere: the record stays, as one that is being removed, until no row is left. */
    private function remove(ImportRecord $record, Resolution $resolution): void
    {
        $this->output->notice("removing $record->productId from {$resolution->table()}");
        $this->records->setState($record, ImportState::Removing);
        if (count($this->records->of($resolution)) === 1) {
            $this->schema->dropElevations($resolution);
        } else {
            $delete = $this->connection->prepare(
                "DELETE FROM {$resolution->table()} WHERE row_index = ? AND col_index >= ? AND col_index < ?"
            );
            for ($row = $record->firstRow; $row < $record->firstRow + $record->rowCount; $row++) {
                $delete->execute([$row, $record->firstColumn, $record->firstColumn + $record->columnCount]);
            }
        }
        $this->records->remove($record);
    }

    private static function change(ImportRecord $record, ImportRecord $wanted): string
    {
        return match (true) {
            $record->formatVersion !== $wanted->formatVersion => 'the layout of the table has changed',
            $record->imageSha256 !== $wanted->imageSha256 => 'the image has changed',
            default => 'the label has changed',
        };
    }
}
