<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Msisf\Scripts\Database\Connection;
use Msisf\Scripts\Database\ImportRecords;
use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Exception\ExternalPartException;
use Msisf\Scripts\Ldem\Resolution;

/** The elevation model that ldem_mysql_insert.php has put into the database. */
final class ElevationTable implements RadiusSource
{
    private function __construct(
        private readonly Resolution $resolution,
        private readonly SampleQuery $query,
        private readonly string $productId,
    ) {
    }

    /**
     * @param Connection $connection to the database of the tables
     * @throws BadInputException nothing was imported, or not all of it
     * @throws ExternalPartException the database failed
     */
    public static function open(Connection $connection, Resolution $resolution, QueryMethod $method): self
    {
        $records = (new ImportRecords($connection))->of($resolution);
        $productId = ImportedModel::productId($resolution, $records);

        return new self($resolution, $method->over($connection, $resolution), $productId);
    }

    public function productId(): string
    {
        return $this->productId;
    }

    public function pixelsPerDegree(): int
    {
        return $this->resolution->value;
    }

    public function radii(int $line, int $lines, int $sample, int $samples): array
    {
        $radii = $this->query->radii($line, $lines, $sample, $samples);
        // The key is (row, column) and the query names both: as many rows as samples are those samples.
        if (count($radii) !== $lines * $samples) {
            throw new BadInputException(sprintf(
                'table %s: only %d of %d samples of lines %d to %d, samples %d to %d are there. Import the product that has them,'
                . ' or run ldem_mysql_insert.php --verify.',
                $this->resolution->table(),
                count($radii),
                $lines * $samples,
                $line + 1,
                $line + $lines,
                $sample + 1,
                $sample + $samples,
            ));
        }

        return $radii;
    }
}
