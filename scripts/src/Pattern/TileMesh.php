<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Generator;

/** The surface of one tile on the lattice. Each vertex depends on its sample alone, so tiles meet bit for bit. */
final class TileMesh
{
    /** @var array{int, int, int} the point from which the offsets count */
    public readonly array $origin;

    /** @var list<float> */
    private readonly array $longitudeSines;

    /** @var list<float> */
    private readonly array $longitudeCosines;

    public function __construct(
        public readonly TileMeshLayout $layout,
        private readonly TileRadii $radii,
        private readonly GridDirections $directions,
    ) {
        $this->origin = Lattice::originOf($layout->tile);
        $longitudes = [];
        for ($column = 0; $column < $layout->samples; $column++) {
            $sample = ($layout->firstSample + $column) % (360 * $layout->pixelsPerDegree);
            $longitudes[] = $directions->longitude($sample);
        }
        $this->longitudeSines = array_column($longitudes, 0);
        $this->longitudeCosines = array_column($longitudes, 1);
    }

    /**
     * The vertices as text: "x,y,z" in lattice steps from the origin, joined by a separator; a pole or a line of samples
     * each time. The loop is the centre of the program's work, so it has no calls but floor().
     *
     * @return Generator<int, string>
     */
    public function vertexLines(string $separator): Generator
    {
        $layout = $this->layout;
        if ($this->radii->northPole !== null) {
            yield $this->line([$this->radii->northPole], [1.0, 0.0], [0.0], [1.0], $separator);
        }
        for ($row = 0; $row < $layout->lines; $row++) {
            $latitude = $this->directions->latitude($layout->firstLine + $row);
            yield $this->line(
                $this->radii->row($row),
                $latitude,
                $this->longitudeSines,
                $this->longitudeCosines,
                $separator,
            );
        }
        if ($this->radii->southPole !== null) {
            yield $this->line([$this->radii->southPole], [-1.0, 0.0], [0.0], [1.0], $separator);
        }
    }

    /**
     * @param list<float>         $radii
     * @param array{float, float} $latitude
     * @param list<float>         $sines
     * @param list<float>         $cosines
     */
    private function line(array $radii, array $latitude, array $sines, array $cosines, string $separator): string
    {
        Lattice::requireReach($this->origin, $radii, $latitude, $sines, $cosines);
        [$originX, $originY, $originZ] = $this->origin;
        [$latitudeSine, $latitudeCosine] = $latitude;
        $vertices = [];
        // Lattice::nearest, written out: a call for each vertex would double the time.
        foreach ($radii as $column => $radius) {
            $steps = Lattice::STEPS_PER_METRE * $radius;
            $equatorial = $steps * $latitudeCosine;
            $x = (int) \floor($equatorial * $cosines[$column] + 0.5) - $originX;
            $y = (int) \floor($equatorial * $sines[$column] + 0.5) - $originY;
            $z = (int) \floor($steps * $latitudeSine + 0.5) - $originZ;
            $vertices[] = "$x,$y,$z";
        }

        return implode($separator, $vertices);
    }
}
