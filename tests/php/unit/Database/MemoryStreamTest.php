<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Database;

use Msisf\Scripts\Database\MemoryStream;
use PHPUnit\Framework\TestCase;

final class MemoryStreamTest extends TestCase
{
    protected function setUp(): void
    {
        MemoryStream::register();
        MemoryStream::register(); // again does no harm
    }

    protected function tearDown(): void
    {
        MemoryStream::withdraw();
    }

    public function testOfferedTextIsReadUnderItsAddress(): void
    {
        $text = str_repeat("1\t2\t1737400.5\n", 3000); // longer than PHP reads at once

        self::assertSame($text, file_get_contents(MemoryStream::offer($text)));
    }

    public function testReadInPiecesEachReaderHasItsOwnPlace(): void
    {
        $address = MemoryStream::offer('abcdef');
        $first = fopen($address, 'rb');
        $second = fopen($address, 'rb');

        self::assertSame(['ab', 'abc', 'cdef', 'def'], [fread($first, 2), fread($second, 3), fread($first, 99), fread($second, 99)]);
        self::assertTrue(feof($first));
        self::assertSame(6, fstat($first)['size']);
    }

    public function testOpenForWritingIsRefused(): void
    {
        self::assertFalse(@fopen(MemoryStream::offer('a'), 'wb'));
    }

    public function testWithdrawnTextIsGone(): void
    {
        $address = MemoryStream::offer('secret rows');
        MemoryStream::withdraw();

        self::assertSame('', file_get_contents($address));
    }
}
