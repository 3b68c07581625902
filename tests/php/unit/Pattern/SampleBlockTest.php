<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Pattern;

use LogicException;
use Msisf\Scripts\Pattern\SampleBlock;
use Msisf\Tests\Support\FormulaRadiusSource;
use PHPUnit\Framework\TestCase;

final class SampleBlockTest extends TestCase
{
    /** @dataProvider blocks */
    public function testLineInsideTheBlockHasTheSamplesAskedFor(int $first, int $width, int $from, int $samples, array $expected): void
    {
        $source = new FormulaRadiusSource(1, static fn (int $line, int $sample): float => 1000.0 * $line + $sample);

        $block = SampleBlock::read($source, 10, 3, $first, $width);

        self::assertSame($expected, $block->line(11, $from, $samples));
    }

    public static function blocks(): array
    {
        return [
            'inside' => [20, 10, 22, 2, [11022.0, 11023.0]],
            'over the seam' => [355, 11, 358, 4, [11358.0, 11359.0, 11000.0, 11001.0]],
            'behind the seam' => [355, 11, 2, 3, [11002.0, 11003.0, 11004.0]],
            'whole line and one sample' => [0, 361, 358, 3, [11358.0, 11359.0, 11000.0]],
            'whole line and a margin' => [358, 365, 359, 3, [11359.0, 11000.0, 11001.0]],
        ];
    }

    public function testLineSampleThatWasNotReadThrows(): void
    {
        $source = new FormulaRadiusSource(1, static fn (): float => 1.0);
        $this->expectException(LogicException::class);
        SampleBlock::read($source, 0, 1, 10, 5)->line(0, 15, 1);
    }
}
