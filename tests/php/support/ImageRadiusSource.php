<?php

declare(strict_types=1);

namespace Msisf\Tests\Support;

use Msisf\Scripts\Pattern\RadiusSource;

/** The radii of a whole-Moon product of 16-bit little-endian samples, 0.5 m each; independent of the scripts' own reader. */
final class ImageRadiusSource implements RadiusSource
{
    private readonly string $samples;

    public function __construct(string $path, private readonly string $productId, private readonly int $pixelsPerDegree)
    {
        $this->samples = (string) file_get_contents($path);
    }

    public function productId(): string
    {
        return $this->productId;
    }

    public function pixelsPerDegree(): int
    {
        return $this->pixelsPerDegree;
    }

    public function radii(int $line, int $lines, int $sample, int $samples): array
    {
        $radii = [];
        for ($row = $line; $row < $line + $lines; $row++) {
            $bytes = substr($this->samples, 2 * ($row * 360 * $this->pixelsPerDegree + $sample), 2 * $samples);
            foreach ((array) unpack('v*', $bytes) as $value) {
                $radii[] = 1737400.0 + 0.5 * ($value < 32768 ? $value : $value - 65536);
            }
        }

        return $radii;
    }
}
