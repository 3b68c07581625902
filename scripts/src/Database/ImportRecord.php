<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

/** A row of ldem_import: a product, the files it came from, where it lies in its table and how much of it is there. */
final class ImportRecord
{
    public function __construct(
        public readonly string $table,
        public readonly string $productId,
        public readonly ImportState $state,
        public readonly int $formatVersion,
        public readonly string $labelSha256,
        public readonly string $imageSha256,
        public readonly int $imageBytes,
        public readonly int $firstRow,
        public readonly int $rowCount,
        public readonly int $firstColumn,
        public readonly int $columnCount,
        public readonly int $rowsDone,
    ) {
    }

    /** Samples of the product that are in the table. */
    public function samplesDone(): int
    {
        return $this->rowsDone * $this->columnCount;
    }

    public function isOfSameFiles(self $other): bool
    {
        return $this->labelSha256 === $other->labelSha256
            && $this->imageSha256 === $other->imageSha256
            && $this->formatVersion === $other->formatVersion;
    }

    /** They share a sample. */
    public function overlaps(self $other): bool
    {
        return $this->firstRow < $other->firstRow + $other->rowCount
            && $other->firstRow < $this->firstRow + $this->rowCount
            && $this->firstColumn < $other->firstColumn + $other->columnCount
            && $other->firstColumn < $this->firstColumn + $this->columnCount;
    }
}
