<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Ldem;

use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Ldem\LdemImagePointer;
use Msisf\Scripts\Ldem\PdsLabelParser;
use PHPUnit\Framework\TestCase;

final class LdemImagePointerTest extends TestCase
{
    /** @dataProvider pointers */
    public function testReadFormsOfThePointer(string $written, ?int $recordBytes, ?string $file, int $offset): void
    {
        $pointer = self::read($written, $recordBytes);

        self::assertSame([$file, $offset], [$pointer->fileName, $pointer->offset]);
    }

    public static function pointers(): array
    {
        return [
            'file' => ['"A.IMG"', 2880, 'A.IMG', 0],
            'file in brackets' => ['("A.IMG")', null, 'A.IMG', 0],
            'file and record' => ['("A.IMG", 3)', 2880, 'A.IMG', 5760],
            'file and byte' => ['("A.IMG", 101 <BYTES>)', 2880, 'A.IMG', 100],
            'record of the label itself' => ['2', 2880, null, 2880],
            'byte of the label itself' => ['1 <bytes>', null, null, 0],
        ];
    }

    /** @dataProvider wrongPointers */
    public function testReadAnythingElseIsRefused(string $written, ?int $recordBytes, string $message): void
    {
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage($message);
        self::read($written, $recordBytes);
    }

    public static function wrongPointers(): array
    {
        return [
            'another folder' => ['"../A.IMG"', 1, 'the plain name of a file beside the label is needed'],
            'another drive' => ['"C:A.IMG"', 1, 'the plain name'],
            'no name' => ['("", 1)', 1, 'the plain name'],
            'name without quotes' => ['(A.IMG, 1)', 1, 'a file name, a place, or both are needed'],
            'three items' => ['("A.IMG", 1, 2)', 1, 'a file name, a place, or both are needed'],
            'nothing' => ['()', 1, 'a file name, a place, or both are needed'],
            'record 0' => ['("A.IMG", 0)', 1, 'a record or byte number from 1 is needed'],
            'too long a number' => ['("A.IMG", 12345678901)', 1, 'a record or byte number from 1'],
            'quoted number' => ['("A.IMG", "3")', 1, 'a record or byte number from 1'],
            'record of unknown length' => ['("A.IMG", 3)', null, 'the label has no RECORD_BYTES'],
            'another unit' => ['("A.IMG", 3 <pix>)', 1, 'the unit <BYTES> or none is needed'],
        ];
    }

    private static function read(string $written, ?int $recordBytes): LdemImagePointer
    {
        return LdemImagePointer::read(PdsLabelParser::parse("PDS_VERSION_ID = PDS3\n^IMAGE = $written\nEND", 'x.LBL'), $recordBytes);
    }
}
