<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Ldem;

use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Ldem\LdemImage;
use Msisf\Scripts\Ldem\LdemLabelReader;
use Msisf\Tests\Support\LabelText;
use Msisf\Tests\Support\Parts;
use Msisf\Tests\Support\TemporaryFolder;
use PHPUnit\Framework\TestCase;

final class LdemImageTest extends TestCase
{
    private TemporaryFolder $folder;

    protected function setUp(): void
    {
        $this->folder = new TemporaryFolder();
    }

    /** ERRATA: LDEM_4 V3.0 has its highest sample, 10504.0 m, at 5.375 N 201.375 E, its lowest, -8878.5 m, at 70.375 S 187.625 E. */
    public function testLinesRealLdem4ExtremesAreWhereTheyAreKnownToBe(): void
    {
        $image = self::open(Parts::ldem4Image());
        foreach ($image->lines() as $line => $values) {
            if ($line === 338) {
                self::assertSame(1747904.0, $image->radius($values[805]));
            } elseif ($line === 641) {
                self::assertSame(1728521.5, $image->radius($values[750]));
            }
        }
        self::assertSame(719, $line);
    }

    /** @dataProvider encodings */
    public function testLinesEveryEncodingGivesTheSameValues(string $type, string $bits, string $format): void
    {
        $values = range(-200, 199);
        $samples = '';
        foreach ($values as $value) {
            $samples .= pack($format, $bits === '16' ? $value & 0xffff : (float) $value);
        }
        $label = LabelText::writeProduct($this->folder, 'P', [15, 10, 10, 15], $samples, ['SAMPLE_TYPE' => $type, 'SAMPLE_BITS' => $bits]);
        $found = array_merge(...iterator_to_array(self::open($label)->lines()));
        self::assertEquals($values, $found);
    }

    public static function encodings(): array
    {
        return [['LSB_INTEGER', '16', 'v'], ['MSB_INTEGER', '16', 'n'], ['PC_REAL', '32', 'g'], ['IEEE_REAL', '32', 'G']];
    }

    public function testLinesBegunLaterGivesTheRest(): void
    {
        $image = self::open(LabelText::writeProduct($this->folder, 'P', [15, 10, 10, 15], LabelText::samples(400)));
        self::assertSame(array_slice(iterator_to_array($image->lines()), 18, null, true), iterator_to_array($image->lines(18)));
    }

    /** @dataProvider wrongValues */
    public function testLinesValueOutsideTheLabelsLimitsIsNamed(string $type, string $bits, string $bad, string $message): void
    {
        $samples = str_repeat("\0", strlen($bad) * 400);
        $samples = substr_replace($samples, $bad, 25 * strlen($bad), strlen($bad));
        $image = self::open(LabelText::writeProduct($this->folder, 'P', [15, 10, 10, 15], $samples, ['SAMPLE_TYPE' => $type, 'SAMPLE_BITS' => $bits]));
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage("P.IMG, line 2, sample 6: the value $message is outside the label's MINIMUM and MAXIMUM");
        iterator_to_array($image->lines());
    }

    public static function wrongValues(): array
    {
        return [
            'NASA\'s missing value' => ['LSB_INTEGER', '16', pack('v', 0x8000), '-32768'],
            'not a number' => ['PC_REAL', '32', pack('g', NAN), 'NAN'],
            'infinite' => ['IEEE_REAL', '32', pack('G', INF), 'INF'],
        ];
    }

    public function testOpenFileOfAnotherLengthIsRefused(): void
    {
        $label = LabelText::writeProduct($this->folder, 'P', [15, 10, 10, 15], LabelText::samples(399));
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage('P.IMG: 798 bytes, 800 expected (20 lines of 40 bytes by');
        self::open($label);
    }

    public function testOpenNameInSmallLettersIsFound(): void
    {
        $label = LabelText::writeProduct($this->folder, 'P', [15, 10, 10, 15], LabelText::samples(400));
        rename($this->folder->path('P.IMG'), $this->folder->path('p.img'));
        self::assertSame($this->folder->path('p.img'), self::open($label)->path);
    }

    public function testOpenAttachedLabelSamplesBeginAfterIt(): void
    {
        $text = str_pad(LabelText::of('P', [15, 10, 10, 15], ['^IMAGE' => '1001 <BYTES>', 'FILE_RECORDS' => '']), 1000);
        self::assertSame(1000, strlen($text));
        file_put_contents($this->folder->path('P.IMG'), str_pad($text, 1000) . LabelText::samples(400));
        self::assertSame(
            array_values(array_map(static fn (int $v): int => $v < 32768 ? $v : $v - 65536, unpack('v20', LabelText::samples(400)))),
            self::open($this->folder->path('P.IMG'))->lines()->current(),
        );
    }

    public function testLinesMemoryDoesNotGrowWithTheProduct(): void
    {
        $image = self::open(Parts::ldem4Image());
        memory_reset_peak_usage();
        $before = memory_get_usage();
        foreach ($image->lines() as $values) {
            self::assertCount(1440, $values);
        }
        self::assertLessThan(1 << 19, memory_get_peak_usage() - $before);
    }

    private static function open(string $path): LdemImage
    {
        return LdemImage::open(LdemLabelReader::readFile($path));
    }
}
