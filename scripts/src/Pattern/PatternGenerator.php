<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

/** Makes the patterns that are not there, damaged, or made from other samples. */
final class PatternGenerator
{
    private readonly PatternWriter $writer;
    private readonly GridDirections $directions;

    /** @var array<int, float> mean radius of the lines beside the poles, by line */
    private array $poles = [];

    /** @param bool $makeAll also make patterns that are there and right */
    public function __construct(
        private readonly RadiusSource $source,
        private readonly PatternRepository $repository,
        private readonly PatternFormat $format,
        private readonly bool $makeAll,
    ) {
        $this->writer = new PatternWriter($format);
        $this->directions = new GridDirections($source->pixelsPerDegree());
    }

    /** Makes sure that the patterns of a batch are there. */
    public function run(TileBatch $batch): GenerationReport
    {
        $start = hrtime(true);
        $block = $batch->read($this->source);
        $tiles = [];
        foreach ($batch->layouts as $layout) {
            $tiles[] = new TileRadii(
                $layout,
                $block,
                $layout->hasNorthPole() ? $this->poleRadius(0) : null,
                $layout->hasSouthPole() ? $this->poleRadius(180 * $layout->pixelsPerDegree - 1) : null,
            );
        }
        $read = hrtime(true);
        $made = 0;
        $writingSeconds = 0.0;
        foreach ($tiles as $radii) {
            $fileSeconds = $this->ensure($radii);
            $made += (int) ($fileSeconds !== null);
            $writingSeconds += $fileSeconds ?? 0.0;
        }
        $computingSeconds = (hrtime(true) - $read) / 1e9 - $writingSeconds;

        return new GenerationReport(
            $made,
            count($tiles) - $made,
            ($read - $start) / 1e9,
            $computingSeconds,
            $writingSeconds,
        );
    }

    /** @return ?float seconds of writing; null if the pattern was there */
    private function ensure(TileRadii $radii): ?float
    {
        $layout = $radii->layout;
        $header = PatternHeader::withoutLength($layout, $radii, $this->source->productId(), $this->format);
        if (!$this->repository->needs($layout->tile, $header) && !$this->makeAll) {
            return null;
        }
        $file = $this->repository->create($layout->tile);
        $this->writer->write($file, new TileMesh($layout, $radii, $this->directions), $header);
        $file->commit();

        return $file->seconds();
    }

    /** The mean radius of a line: the sum from west to east, one rounding an addition, divided by the count. */
    private function poleRadius(int $line): float
    {
        $samples = 360 * $this->source->pixelsPerDegree();

        return $this->poles[$line] ??= array_sum($this->source->radii($line, 1, 0, $samples)) / $samples;
    }
}
