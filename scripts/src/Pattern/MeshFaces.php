<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Generator;

/** The triangles of a layout, three vertex numbers each, counter-clockwise seen from outside. */
final class MeshFaces
{
    /**
     * The north fan (pole, SW, SE); for each cell, line by line, (NW, SW, SE) and (NW, SE, NE), so that the diagonal runs
     * from north-west to south-east; the south fan (NW, pole, NE).
     *
     * @return Generator<int, list<array{int, int, int}>> a fan or a line of cells each time
     */
    public static function of(TileMeshLayout $layout): Generator
    {
        $samples = $layout->samples;
        $firstRow = (int) $layout->hasNorthPole();
        if ($layout->hasNorthPole()) {
            yield array_map(static fn (int $south): array => [0, $south, $south + 1], range(1, $samples - 1));
        }
        for ($row = 0; $row < $layout->lines - 1; $row++) {
            $faces = [];
            $northWest = $firstRow + $row * $samples;
            for ($end = $northWest + $samples - 1; $northWest < $end; $northWest++) {
                $southWest = $northWest + $samples;
                $faces[] = [$northWest, $southWest, $southWest + 1];
                $faces[] = [$northWest, $southWest + 1, $northWest + 1];
            }
            yield $faces;
        }
        if ($layout->hasSouthPole()) {
            $pole = $layout->vertexCount() - 1;
            yield array_map(
                static fn (int $northWest): array => [$northWest, $pole, $northWest + 1],
                range($pole - $samples, $pole - 2),
            );
        }
    }
}
