<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Generator;

/** The thesis's form of a pattern: one triangle after the other, in kilometres from the Moon's centre. */
final class TriangleText
{
    /** 1e10 / 128 000: a lattice step in units of 1e-10 km, exactly. */
    private const STEP_IN_DECIMALS = 78125;

    private const DECIMALS_IN_KILOMETRE = 10_000_000_000;

    /** @return Generator<int, string> */
    public static function of(TileMesh $mesh): Generator
    {
        $vertices = [];
        foreach ($mesh->vertexLines("\n") as $line) {
            foreach (explode("\n", $line) as $offsets) {
                $vertices[] = self::position($mesh->origin, $offsets);
            }
        }
        yield "mesh {\n";
        foreach (MeshFaces::of($mesh->layout) as $faces) {
            $text = '';
            foreach ($faces as [$a, $b, $c]) {
                $text .= "triangle {\n$vertices[$a], $vertices[$b], $vertices[$c]\ntexture { moon }\n}\n";
            }
            yield $text;
        }
        yield "}\n";
    }

    /** @param array{int, int, int} $origin */
    private static function position(array $origin, string $offsets): string
    {
        [$x, $y, $z] = array_map('intval', explode(',', $offsets));

        return '<' . self::kilometres($origin[0] + $x) . ', ' . self::kilometres($origin[1] + $y) . ', '
            . self::kilometres($origin[2] + $z) . '>';
    }

    private static function kilometres(int $steps): string
    {
        $decimals = abs($steps) * self::STEP_IN_DECIMALS;

        return sprintf(
            '%s%d.%010d',
            $steps < 0 ? '-' : '',
            intdiv($decimals, self::DECIMALS_IN_KILOMETRE),
            $decimals % self::DECIMALS_IN_KILOMETRE,
        );
    }
}
