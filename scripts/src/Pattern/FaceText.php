<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Generator;

/** The faces of a mesh2 as text. All tiles of a row share theirs, so the last one is kept. */
final class FaceText
{
    /** Faces up to which the text is kept: about 10 MB. */
    private const MOST_KEPT = 500_000;

    private string $keptFor = '';
    private string $kept = '';

    /** @return Generator<int, string> each face as ",\n<a,b,c>" */
    public function of(TileMeshLayout $layout): Generator
    {
        if ($layout->faceCount() > self::MOST_KEPT) {
            yield from self::pieces($layout);

            return;
        }
        $poles = (int) $layout->hasNorthPole() . (int) $layout->hasSouthPole();
        $shape = "$layout->lines x $layout->samples, $poles";
        if ($shape !== $this->keptFor) {
            $this->kept = implode('', iterator_to_array(self::pieces($layout), false));
            $this->keptFor = $shape;
        }
        yield $this->kept;
    }

    /** @return Generator<int, string> */
    private static function pieces(TileMeshLayout $layout): Generator
    {
        foreach (MeshFaces::of($layout) as $faces) {
            $text = [];
            foreach ($faces as [$a, $b, $c]) {
                $text[] = ",\n<$a,$b,$c>";
            }
            yield implode('', $text);
        }
    }
}
