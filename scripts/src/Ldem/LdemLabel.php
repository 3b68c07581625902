<?php

declare(strict_types=1);

namespace Msisf\Scripts\Ldem;

/** What the label of a cylindrical lunar elevation model says, checked for consistency. It may cover a part of the Moon only. */
final class LdemLabel
{
    /**
     * @param string $imagePath the label's own path for an attached label
     * @param int $imageOffset bytes of the image's file before the first sample
     * @param int|null $fileBytes bytes that the image's file must have; null if the label names no number of records
     * @param string $productId e.g. "LDEM_4": letters, digits, '_', '-' and '.'
     * @param float $scalingFactor m a step
     * @param float $offset m: the radius that sample value 0 means
     * @param float $minimum no sample value is below
     * @param float $maximum no sample value is above
     * @param string $sha256 SHA-256 of the label's bytes (of an attached label: to its END)
     */
    public function __construct(
        public readonly string $labelPath,
        public readonly string $imagePath,
        public readonly int $imageOffset,
        public readonly ?int $fileBytes,
        public readonly string $productId,
        public readonly int $pixelsPerDegree,
        public readonly int $lines,
        public readonly int $lineSamples,
        public readonly SampleType $sampleType,
        public readonly float $scalingFactor,
        public readonly float $offset,
        public readonly float $minimum,
        public readonly float $maximum,
        public readonly float $northDegrees,
        public readonly float $southDegrees,
        public readonly float $westDegrees,
        public readonly float $eastDegrees,
        public readonly string $sha256,
    ) {
    }

    public function lineBytes(): int
    {
        return $this->lineSamples * $this->sampleType->bytes();
    }

    /** Bytes of the samples, without what stands before them. */
    public function imageBytes(): int
    {
        return $this->lineBytes() * $this->lines;
    }

    /** The whole Moon's line, counted from 0 at the north pole, that is the product's first. */
    public function firstLine(): int
    {
        return (int) ((90.0 - $this->northDegrees) * $this->pixelsPerDegree);
    }

    /** The whole Moon's sample, counted from 0 at the prime meridian eastward, that is the product's first. */
    public function firstSample(): int
    {
        return (int) ($this->westDegrees * $this->pixelsPerDegree);
    }
}
