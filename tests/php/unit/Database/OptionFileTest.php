<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Database;

use Msisf\Scripts\Database\OptionFile;
use Msisf\Scripts\Exception\BadInputException;
use Msisf\Tests\Support\TemporaryFolder;
use PHPUnit\Framework\TestCase;

final class OptionFileTest extends TestCase
{
    private TemporaryFolder $folder;

    protected function setUp(): void
    {
        $this->folder = new TemporaryFolder();
    }

    /** @dataProvider files */
    public function testReadTakesTheKnownNamesOfTheClientGroup(string $text, array $expected): void
    {
        self::assertSame($expected, $this->read($text));
    }

    public static function files(): array
    {
        return [
            'empty' => ['', []],
            'no group' => ["user=me\n", []],
            'CRLF and old Mac line ends' => ["[client]\r\nuser=me\rhost=h\r\n", ['user' => 'me', 'host' => 'h']],
            'group that comes back' => ["[client]\nuser=me\n[x]\nuser=you\n[client]\nport=1\n", ['user' => 'me', 'port' => '1']],
            'the last one counts' => ["[client]\nuser=a\nuser=b\n", ['user' => 'b']],
            'blanks about everything' => ["  [client]  \n\t user \t=  me \t\n", ['user' => 'me']],
            'comments' => ["; a\n# b\n[client]\n#user=x\nuser=me # x\n", ['user' => 'me']],
            'name alone' => ["[client]\nuser\n", ['user' => '']],
            'group with another beginning' => ["[client-mariadb]\nuser=x\n", []],
        ];
    }

    /** @dataProvider values */
    public function testReadValueIsUnquotedAsTheClientDoes(string $written, string $expected): void
    {
        self::assertSame(['user' => $expected], $this->read("[client]\nuser=$written\n"));
    }

    public static function values(): array
    {
        return [
            'single quotes' => ["'a # b'", 'a # b'],
            'comment behind quotes' => ['"a" # b', 'a'],
            'quote in quotes' => ['"a\"b"', 'a"b'],
            'quote without a partner' => ['"a', '"a'],
            'two kinds of quotes' => ['"a\'', '"a\''],
            'hash without a blank' => ['a#b', 'a#b'],
            'escapes' => ['a\\tb\\nc\\\\d', "a\tb\nc\\d"],
            'escape that is none' => ['a\\q', 'a\\q'],
        ];
    }

    public function testReadMissingFileIsRefused(): void
    {
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage('this option file is missing or can\'t be read');
        OptionFile::read($this->folder->path('none.cnf'));
    }

    /** @dataProvider wrongLines */
    public function testReadLineThatIsNoOptionIsRefusedByNumber(string $text, int $line): void
    {
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage("my.cnf, line $line: neither [group] nor name=value");
        $this->read($text);
    }

    public static function wrongLines(): array
    {
        return [
            'include' => ["[client]\n!include other.cnf\n", 2],
            'in another group' => ["[mysqld]\n\nwhat is this\n", 3],
            'group without an end' => ["[client\n", 1],
        ];
    }

    /** @dataProvider rights */
    public function testReadPasswordMustBeTheOwnersAlone(int $rights, string $text, bool $isRefused): void
    {
        if ($isRefused) {
            $this->expectException(BadInputException::class);
            $this->expectExceptionMessage('other users may read it');
        }
        self::assertArrayHasKey('user', $this->read($text, $rights));
    }

    public static function rights(): array
    {
        return [
            'the owner may write' => [0o600, "[client]\nuser=u\npassword=p\n", false],
            'the group may read' => [0o640, "[client]\nuser=u\npassword=p\n", true],
            'all may read' => [0o604, "[client]\nuser=u\npassword=p\n", true],
            'no password' => [0o644, "[client]\nuser=u\n", false],
            'password of another group' => [0o644, "[mysqld]\npassword=p\n[client]\nuser=u\n", false],
        ];
    }

    /** @return array<string, string> */
    private function read(string $text, int $rights = 0o600): array
    {
        $path = $this->folder->path('my.cnf');
        file_put_contents($path, $text);
        chmod($path, $rights);

        return OptionFile::read($path);
    }
}
