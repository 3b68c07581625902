<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Database;

use Msisf\Scripts\Database\RowText;
use Msisf\Scripts\Ldem\LdemImage;
use Msisf\Scripts\Ldem\LdemLabelReader;
use Msisf\Tests\Support\LabelText;
use Msisf\Tests\Support\TemporaryFolder;
use PHPUnit\Framework\TestCase;

final class RowTextTest extends TestCase
{
    private TemporaryFolder $folder;

    protected function setUp(): void
    {
        $this->folder = new TemporaryFolder();
    }

    public function testChunksColumnByColumnWithPlacesOfTheWholeMoon(): void
    {
        // 10 to 15 degrees north and east at 4 px/deg: the product's line 0 is line 300 of the Moon, its sample 0 sample 40.
        $rows = $this->rows([], [2 => [-3, ...array_fill(0, 19, 1)], 3 => [4, ...array_fill(0, 19, 0)]]);

        self::assertCount(40, $rows);
        self::assertSame(
            ["302\t40\t1737398.5", "303\t40\t1737402", "302\t41\t1737400.5", "303\t41\t1737400", "303\t59\t1737400"],
            [...array_slice($rows, 0, 4), $rows[39]],
        );
    }

    public function testChunksFloatsKeepAllTheirDigits(): void
    {
        $changes = ['SAMPLE_TYPE' => 'PC_REAL', 'SAMPLE_BITS' => '32', 'SCALING_FACTOR' => '1'];

        $rows = $this->rows($changes, [0 => [0.123456789, ...array_fill(0, 19, 1.0)]]);

        self::assertSame("300\t40\t1737400.123456789", $rows[0]);
    }

    public function testChunksLongBandComesInPiecesOfWholeColumns(): void
    {
        $band = array_fill(0, 6000, array_fill(0, 20, 0));

        $sizes = array_map('count', iterator_to_array($this->text([])->chunks($band), false));

        // 20,000 rows at least: four columns of 6000.
        self::assertSame([24000, 24000, 24000, 24000, 24000], $sizes);
    }

    /**
     * @param array<string, string> $changes of the label
     * @param array<int, list<int|float>> $band
     * @return list<string>
     */
    private function rows(array $changes, array $band): array
    {
        return array_merge(...iterator_to_array($this->text($changes)->chunks($band), false));
    }

    private function text(array $changes): RowText
    {
        $bytes = ($changes['SAMPLE_BITS'] ?? '16') === '16' ? 800 : 1600;
        $label = LabelText::writeProduct($this->folder, 'P', [15, 10, 10, 15], str_repeat("\0", $bytes), $changes);

        return new RowText(LdemImage::open(LdemLabelReader::readFile($label)));
    }
}
