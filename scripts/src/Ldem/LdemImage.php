<?php

declare(strict_types=1);

namespace Msisf\Scripts\Ldem;

use Generator;
use Msisf\Scripts\Exception\BadInputException;

/** The samples of a product, read line by line: memory does not grow with the product. */
final class LdemImage
{
    /** Part of MAXIMUM - MINIMUM by which a 32-bit float may pass them: labels print them with few digits. */
    private const FLOAT_LIMIT_SLACK = 1e-3;

    private readonly float $lowest;

    private readonly float $highest;

    /** @param resource $file */
    private function __construct(
        public readonly LdemLabel $label,
        public readonly string $path,
        private readonly mixed $file,
    ) {
        $slack = $label->sampleType->isInteger() ? 0.0 : self::FLOAT_LIMIT_SLACK * ($label->maximum - $label->minimum);
        $this->lowest = $label->minimum - $slack;
        $this->highest = $label->maximum + $slack;
    }

    /** @throws BadInputException the image is missing, unreadable, or not as long as the label says */
    public static function open(LdemLabel $label): self
    {
        $path = FileNames::findIgnoringCase($label->imagePath) ?? throw BadInputException::inFile(
            $label->imagePath,
            "missing; $label->labelPath says that the samples are there. Put the file beside its label."
        );
        $file = @fopen($path, 'rb') ?: throw BadInputException::inFile($path, 'can\'t be read. Check its rights.');
        $found = fstat($file)['size'];
        $expected = $label->fileBytes ?? $label->imageOffset + $label->imageBytes();
        if ($found !== $expected) {
            throw BadInputException::inFile($path, "$found bytes, $expected expected ($label->lines lines of "
                . $label->lineBytes() . " bytes by $label->labelPath). Get the file again.");
        }

        return new self($label, $path, $file);
    }

    /** SHA-256 of the whole file. */
    public function sha256(): string
    {
        $hash = hash_init('sha256');
        rewind($this->file);
        hash_update_stream($hash, $this->file);

        return hash_final($hash);
    }

    /** When the file was last written to and how long it is: other values after the reading mean that it was changed meanwhile. */
    public function state(): string
    {
        clearstatcache();
        $now = @stat($this->path) ?: ['mtime' => 0, 'size' => -1, 'ino' => 0];

        return "$now[mtime] $now[size] $now[ino]";
    }

    /**
     * The sample values, as they are in the file.
     *
     * @param int $firstLine the product's line to begin with, from 0
     * @return Generator<int, list<int|float>> by the product's line; each has all samples of the line from the west
     * @throws BadInputException the file ends early, or a value is outside the label's limits
     */
    public function lines(int $firstLine = 0): Generator
    {
        $bytes = $this->label->lineBytes();
        for ($line = $firstLine; $line < $this->label->lines; $line++) {
            fseek($this->file, $this->label->imageOffset + $line * $bytes);
            $samples = stream_get_contents($this->file, $bytes);
            if (strlen((string) $samples) !== $bytes) {
                throw BadInputException::inFile($this->path, "ends in line " . ($line + 1) . '; it became shorter. Get the file again.');
            }
            $values = $this->label->sampleType->decode($samples);
            $this->checkLimits($values, $line);
            yield $line => $values;
        }
    }

    /** m: OFFSET + SCALING_FACTOR * value in doubles, in this order, as msis computes it. */
    public function radius(int|float $value): float
    {
        return $this->label->offset + ($this->label->scalingFactor * $value);
    }

    /** @param list<int|float> $values */
    private function checkLimits(array $values, int $line): void
    {
        // max() and min() may pass over NaN, depending on its place; the sum does not.
        if (min($values) >= $this->lowest && max($values) <= $this->highest && is_finite((float) array_sum($values))) {
            return;
        }
        foreach ($values as $sample => $value) {
            if (!($value >= $this->lowest && $value <= $this->highest)) {
                throw BadInputException::inFile($this->path . ', line ' . ($line + 1) . ', sample ' . ($sample + 1), "the value "
                    . "$value is outside the label's MINIMUM and MAXIMUM ({$this->label->minimum} to {$this->label->maximum})."
                    . ' The file is damaged, or the label belongs to another one: get both again.');
            }
        }
    }
}
