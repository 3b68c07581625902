<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Database;

use Msisf\Scripts\Database\ServerVersion;
use Msisf\Scripts\Exception\ExternalPartException;
use PHPUnit\Framework\TestCase;

final class ServerVersionTest extends TestCase
{
    /** @dataProvider fitVersions */
    public function testParseFitServerIsNamed(string $text, string $expected): void
    {
        self::assertSame($expected, (string) ServerVersion::parse($text));
    }

    public static function fitVersions(): array
    {
        return [
            ['10.11.19-MariaDB-0+deb12u1', 'MariaDB 10.11.19'],
            ['5.5.5-10.5.23-MariaDB-log', 'MariaDB 10.5.23'],
            ['11.4.2-MariaDB-ubu2404', 'MariaDB 11.4.2'],
            ['8.0.36', 'MySQL 8.0.36'],
            ['8.4.0-commercial', 'MySQL 8.4.0'],
            ['8.0.36-28', 'MySQL 8.0.36'],
            'the oldest MariaDB' => ['10.5.0-MariaDB', 'MariaDB 10.5.0'],
            'the oldest MySQL' => ['8.0.0', 'MySQL 8.0.0'],
            'not older than 10.5, as texts would be' => ['10.10.2-mariadb', 'MariaDB 10.10.2'],
        ];
    }

    /** @dataProvider unfitVersions */
    public function testParseUnfitServerIsRefused(string $text, string $message): void
    {
        $this->expectException(ExternalPartException::class);
        $this->expectExceptionMessage($message);
        ServerVersion::parse($text);
    }

    public static function unfitVersions(): array
    {
        return [
            ['5.7.44', 'MySQL 5.7.44 is too old; MariaDB 10.5 or MySQL 8.0, or later, is needed'],
            ['10.4.33-MariaDB', 'MariaDB 10.4.33 is too old'],
            ['5.5.5-10.3.1-MariaDB', 'MariaDB 10.3.1 is too old'],
            ['8.0', "the server says that its version is '8.0'"],
            ['', "the server says that its version is ''"],
            ["8.0\nDROP", 'the server says that its version is \'8.0\nDROP\''],
        ];
    }
}
