<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Pattern;

use Msisf\Scripts\Pattern\FaceText;
use Msisf\Scripts\Pattern\TileId;
use Msisf\Scripts\Pattern\TileMeshLayout;
use PHPUnit\Framework\TestCase;

final class FaceTextTest extends TestCase
{
    public function testOfEachLayoutIsItsOwnWhateverCameBefore(): void
    {
        $faces = new FaceText();

        // The text that is kept is that of the layout before: once of the same shape, once with a pole, once of another size.
        self::assertStringStartsWith(",\n<0,6,7>,\n<0,7,1>,\n<1,7,8>", self::text($faces, 0, 1));
        self::assertSame(self::text(new FaceText(), 0, 1), self::text($faces, 5, 1));
        self::assertStringStartsWith(",\n<0,1,2>,\n<0,2,3>", self::text($faces, 85, 1));
        self::assertStringStartsWith(",\n<0,11,12>,\n<0,12,1>", self::text($faces, 0, 2));
        self::assertSame(50, substr_count(self::text($faces, 0, 1), '<'));
    }

    public function testOfFineLayoutComesInPiecesInsteadOfBeingKept(): void
    {
        // 1280 x 1280 cells of two faces each at 256 px/deg; the text of all would have 60 MB.
        $pieces = (new FaceText())->of(TileMeshLayout::for(new TileId(0, 0), 256, 0));

        self::assertSame(2560, substr_count($pieces->current(), '<'));
        self::assertStringStartsWith(",\n<0,1281,1282>,\n<0,1282,1>", $pieces->current());
    }

    private static function text(FaceText $faces, int $south, int $pixelsPerDegree): string
    {
        return implode('', iterator_to_array($faces->of(TileMeshLayout::for(new TileId($south, 0), $pixelsPerDegree, 0)), false));
    }
}
