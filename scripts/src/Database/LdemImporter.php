<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Closure;
use Generator;
use Msisf\Scripts\Console\Output;
use Msisf\Scripts\Console\Progress;
use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Ldem\LdemImage;
use Msisf\Scripts\Ldem\Resolution;

/**
 * Brings a product into the table of its resolution. A band of lines and the note that it is done are one transaction: after
 * any interruption the next run goes on with the first band that is not there.
 */
final class LdemImporter
{
    /**
     * Lines a transaction. The spatial index of LDEM_4 takes a quarter less time with 40 than with 20 or line by line; more
     * lines bring nothing, and cost memory: 40 lines of LDEM_256 are 44 MB on the server and 30 MB here.
     */
    private const BAND_LINES = 40;

    private readonly ImportRecords $records;

    private readonly Schema $schema;

    /** @param Closure(Connection): RadiusLoader $loaderFor the bulk way */
    public function __construct(
        private readonly Connection $connection,
        private readonly Output $output,
        private readonly Closure $loaderFor,
    ) {
        $this->records = new ImportRecords($connection);
        $this->schema = new Schema($connection);
    }

    /**
     * @param bool $replace delete what is there of the product in another version, and of products that overlap
     * @param int $patienceSeconds how long to wait for another import into the same table
     * @return ImportRecord what is in the table now
     * @throws BadInputException other data are in the table where the product belongs
     */
    public function import(LdemImage $image, bool $replace, int $patienceSeconds): ImportRecord
    {
        $resolution = Resolution::of($image->label->pixelsPerDegree);
        $this->schema->createImports();
        ImportLock::take($this->connection, $resolution, $patienceSeconds, $this->output->notice(...));
        $stateBefore = $image->state();
        $record = ProductRecord::of($image, $resolution);
        $found = (new ImportRemoval($this->connection, $this->output))->makeRoom($record, $resolution, $replace);
        if ($found?->state === ImportState::Complete) {
            $this->output->notice("$record->productId is in {$resolution->table()} already");

            return $found;
        }
        if ($found === null) {
            $this->records->add($record);
        }
        $this->schema->createElevations($resolution);
        $this->schema->requireOwn($resolution);
        $this->fill($image, $resolution, $found ?? $record);
        if ($image->state() !== $stateBefore) {
            throw BadInputException::inFile($image->path, 'was changed while it was read. Import it again with --replace.');
        }
        $this->records->setState($record, ImportState::Complete);
        // Up-to-date estimates: without them a server may read the whole table where an index would do.
        $this->connection->rows("ANALYZE TABLE {$resolution->table()}");

        return $this->recordOf($record, $resolution);
    }

    private function fill(LdemImage $image, Resolution $resolution, ImportRecord $record): void
    {
        $loader = ($this->loaderFor)($this->connection);
        $resumed = $record->rowsDone === 0 ? '' : ", going on after line $record->rowsDone";
        $target = "{$resolution->table()} of {$this->connection->serverVersion}";
        $this->output->notice("$record->productId into $target by {$loader->name()}$resumed");
        $grid = new GridTables($this->connection, $resolution, $image->label);
        $grid->create();
        $text = new RowText($image);
        $progress = new Progress($this->output, 'rows', $record->rowCount * $record->columnCount, $record->samplesDone());
        foreach ($this->bands($image, $record->rowsDone) as $rowsDone => $band) {
            foreach ($text->chunks($band) as $rows) {
                $loader->load($rows);
            }
            $this->connection->inTransaction(function () use ($grid, $record, $rowsDone): void {
                $grid->insertElevations();
                $this->records->setRowsDone($record, $rowsDone);
            });
            $grid->clearRadii();
            $progress->reach($rowsDone * $record->columnCount);
        }
        $progress->finish();
    }

    /** @return Generator<int, array<int, list<int|float>>> bands by the number of lines that are done with them */
    private function bands(LdemImage $image, int $firstLine): Generator
    {
        $band = [];
        foreach ($image->lines($firstLine) as $line => $values) {
            $band[$line] = $values;
            if (count($band) === self::BAND_LINES || $line + 1 === $image->label->lines) {
                yield $line + 1 => $band;
                $band = [];
            }
        }
    }

    private function recordOf(ImportRecord $record, Resolution $resolution): ImportRecord
    {
        foreach ($this->records->of($resolution) as $found) {
            if ($found->productId === $record->productId) {
                return $found;
            }
        }
        throw new BadInputException("$record->productId was removed from {$resolution->table()} while it was imported. Import it again.");
    }
}
