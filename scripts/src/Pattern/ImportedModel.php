<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Msisf\Scripts\Database\ImportRecord;
use Msisf\Scripts\Database\ImportState;
use Msisf\Scripts\Database\Schema;
use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Ldem\Resolution;

/** What the records of the imports say about a table: whether patterns can be made of it, and which model it holds. */
final class ImportedModel
{
    /** How NASA names the parts of a model above 128 px/deg: LDEM_512_00N_45N_000_090. */
    private const PART = '/_\d{2}[NS]_\d{2}[NS]_\d{3}_\d{3}$/D';

    /**
     * The model's name for the patterns; parts of one model have the model's name.
     *
     * @param list<ImportRecord> $records all of the table
     *
     * @throws BadInputException nothing was imported, not all of it, or parts of several models
     */
    public static function productId(Resolution $resolution, array $records): string
    {
        $names = [];
        foreach ($records as $record) {
            self::requireWhole($record);
            $names[] = (string) preg_replace(self::PART, '', $record->productId);
        }
        $names = array_values(array_unique($names));
        $table = $resolution->table();
        if ($names === []) {
            throw new BadInputException(
                "table $table: no elevation model of $resolution->value px/deg is in the database. Import it with ldem_mysql_insert.php.",
            );
        }
        if (count($names) > 1) {
            throw new BadInputException("table $table: it holds parts of several models (" . implode(', ', $names)
                . '). Import each into a database of its own.');
        }
        if (preg_match('/^[A-Za-z0-9_.-]{1,40}$/D', $names[0]) !== 1) {
            throw new BadInputException("table $table: the record of the import has a product without a proper name. Import it again.");
        }

        return $names[0];
    }

    private static function requireWhole(ImportRecord $record): void
    {
        if ($record->formatVersion !== Schema::FORMAT_VERSION) {
            throw new BadInputException("table $record->table: $record->productId was imported in format $record->formatVersion, this is "
                . Schema::FORMAT_VERSION . '. Import it again.');
        }
        if ($record->state !== ImportState::Complete || $record->rowsDone !== $record->rowCount) {
            throw new BadInputException("table $record->table: the import of $record->productId is not complete ($record->rowsDone of "
                . "$record->rowCount lines, state {$record->state->value}). Run ldem_mysql_insert.php again: it goes on where it stopped.");
        }
    }
}
