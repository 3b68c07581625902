<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Ldem;

use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Ldem\LdemLabel;
use Msisf\Scripts\Ldem\LdemLabelReader;
use Msisf\Scripts\Ldem\SampleType;
use Msisf\Tests\Support\LabelText;
use Msisf\Tests\Support\Parts;
use PHPUnit\Framework\TestCase;

final class LdemLabelReaderTest extends TestCase
{
    public function testReadFileRealLdem4(): void
    {
        $label = LdemLabelReader::readFile(Parts::ldem4Image());
        self::assertSame(
            ['LDEM_4', 4, 720, 1440, SampleType::Int16LittleEndian, 0.5, 1737400.0, 0, 0, 2073600, 2880],
            [
                $label->productId, $label->pixelsPerDegree, $label->lines, $label->lineSamples, $label->sampleType, $label->scalingFactor,
                $label->offset, $label->firstLine(), $label->firstSample(), $label->imageBytes(), $label->lineBytes(),
            ],
        );
    }

    public function testReadPartOfTheMoonKnowsItsPlace(): void
    {
        $label = self::read([]);
        self::assertSame([300, 40], [$label->firstLine(), $label->firstSample()]);
    }

    /** The thesis's listing 4.2: LDEM_1024_00N_15N_330_360 has SAMPLE_PROJECTION_OFFSET -153600.5, east of its centre. */
    public function testReadOffsetsOfTheThesissPartialProductAreAccepted(): void
    {
        $text = LabelText::of('LDEM_1024_00N_15N_330_360', [15, 0, 330, 360], [
            'MAP_RESOLUTION' => '1024 <pix/deg>', 'LINES' => '15360', 'LINE_SAMPLES' => '30720', 'FILE_RECORDS' => '15360',
            'RECORD_BYTES' => '61440', 'LINE_PROJECTION_OFFSET' => '15359.5 <pix>', 'SAMPLE_PROJECTION_OFFSET' => '-153600.5 <pix>',
        ]);
        $label = LdemLabelReader::read($text, 'x.LBL');
        self::assertSame([76800, 337920], [$label->firstLine(), $label->firstSample()]);
    }

    /** @dataProvider sampleTypes */
    public function testReadSampleTypes(string $type, string $bits, SampleType $expected): void
    {
        self::assertSame($expected, self::read(['SAMPLE_TYPE' => $type, 'SAMPLE_BITS' => $bits])->sampleType);
    }

    public static function sampleTypes(): array
    {
        return [
            ['LSB_INTEGER', '16', SampleType::Int16LittleEndian],
            ['MSB_INTEGER', '16', SampleType::Int16BigEndian],
            ['PC_REAL', '32', SampleType::Float32LittleEndian],
            ['IEEE_REAL', '32', SampleType::Float32BigEndian],
            ['SUN_INTEGER', '16', SampleType::Int16BigEndian],
            ['"VAX INTEGER"', '16', SampleType::Int16LittleEndian],
            ['"PC REAL"', '32', SampleType::Float32LittleEndian],
            ['mac-real', '32', SampleType::Float32BigEndian],
            ['REAL', '32', SampleType::Float32BigEndian],
        ];
    }

    public function testReadOtherSpellingsSayTheSame(): void
    {
        $other = get_object_vars(self::read([
            'MAP_PROJECTION_TYPE' => 'Simple_Cylindrical', 'POSITIVE_LONGITUDE_DIRECTION' => 'east', 'UNIT' => '"metres"',
            'MAP_RESOLUTION' => '4 <PIXELS / DEGREE>', 'MAXIMUM_LATITUDE' => '15 <DEGREES>',
            'COORDINATE_SYSTEM_NAME' => '"MEAN_EARTH/POLAR_AXIS OF DE421"', 'A_AXIS_RADIUS' => '1737.4 <KILOMETRES>',
        ]));
        self::assertSame(array_merge($other, ['sha256' => '']), array_merge(get_object_vars(self::read([])), ['sha256' => '']));
    }

    public function testReadKilometresBecomeMetres(): void
    {
        $label = self::read([
            'UNIT' => 'KILOMETER', 'SCALING_FACTOR' => '0.0005', 'OFFSET' => '1737.4', 'MINIMUM' => '-10', 'MAXIMUM' => '10',
        ]);
        self::assertSame([0.5, 1737400.0], [$label->scalingFactor, $label->offset]);
    }

    /** @dataProvider wrongLabels */
    public function testReadLabelThatLiesIsRefusedWithKeywordAndReason(array $changes, string $message): void
    {
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage($message);
        self::read($changes);
    }

    public static function wrongLabels(): array
    {
        return [
            'lines' => [['LINES' => '21'], 'LINES = 21; the map\'s borders and MAP_RESOLUTION (5 degrees, 4 px/deg) need 20.'],
            'samples' => [['LINE_SAMPLES' => '19'], 'LINE_SAMPLES = 19'],
            'records' => [['FILE_RECORDS' => '19'], 'FILE_RECORDS = 19; with RECORD_BYTES = 40 these are 760 bytes, but the image needs 800'],
            'offset' => [['LINE_PROJECTION_OFFSET' => '60.5'], 'the rest of the label needs 59.5'],
            'real of a VAX' => [['SAMPLE_TYPE' => 'VAX_REAL', 'SAMPLE_BITS' => '32'], 'SAMPLE_TYPE = VAX_REAL; with SAMPLE_BITS = 32'],
            'offset in another unit' => [['OFFSET' => '1737.4 <km>'], 'OFFSET = 1737.4 <km>; the unit <m> is needed'],
            'type' => [['SAMPLE_BITS' => '8'], 'SAMPLE_TYPE = LSB_INTEGER; with SAMPLE_BITS = 8 it is not known'],
            'polar' => [['MAP_PROJECTION_TYPE' => '"POLAR STEREOGRAPHIC"'], 'polar products can\'t be used'],
            'frame' => [['COORDINATE_SYSTEM_NAME' => '"PRINCIPAL AXIS"'], 'MEAN EARTH/POLAR AXIS frame is needed'],
            'unit' => [['UNIT' => 'FOOT'], 'METER or KILOMETER is needed'],
            'sphere' => [['A_AXIS_RADIUS' => '1738 <km>'], 'the heights are over a sphere of 1737400 m'],
            'scale' => [['SCALING_FACTOR' => '-0.5'], 'a number above 0 is needed'],
            'not a number' => [['OFFSET' => '1e999'], 'a finite number is needed'],
            'missing' => [['MINIMUM' => ''], 'IMAGE has no MINIMUM'],
            'image in another folder' => [['^IMAGE' => '"../../etc/passwd"'], 'the plain name of a file beside the label is needed'],
        ];
    }

    /** @dataProvider wrongTexts */
    public function testReadTextThatIsNoLabelIsRefused(string $text, string $message): void
    {
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage($message);
        LdemLabelReader::read($text, 'x.LBL');
    }

    public static function wrongTexts(): array
    {
        $good = LabelText::of('P', [15, 10, 10, 15]);

        return [
            'empty' => ['', 'not a PDS3 label'],
            'html' => ['<html>404</html>', 'not a PDS3 label'],
            'cut off' => [substr($good, 0, 400), 'the label ends'],
            'SQL as product' => [str_replace('"P"', '"P\'; DROP TABLE ldem_4; --"', $good), 'PRODUCT_ID = P\'; DROP TABLE ldem_4; --; 1 to 40 letters'],
            'nested without end' => ['PDS_VERSION_ID = PDS3 A = ' . str_repeat('(', 40), 'nested too deep'],
            'endless quotation' => ['PDS_VERSION_ID = "PDS3', 'line 1: the quotation that begins here has no end'],
            'endless comment' => ["PDS_VERSION_ID = PDS3\n/* ", 'line 2: the comment that begins here has no end'],
            'contradiction' => [str_replace('TARGET_NAME = MOON', "TARGET_NAME = MOON\r\nTARGET_NAME = MARS", $good), 'TARGET_NAME = MARS; line 4 of the same object says MOON'],
        ];
    }

    private static function read(array $changes): LdemLabel
    {
        return LdemLabelReader::read(LabelText::of('P', [15, 10, 10, 15], $changes), 'folder/P.LBL');
    }
}
