<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Database;

use Msisf\Scripts\Database\ConnectionSettings;
use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Exception\MsisfException;
use Msisf\Scripts\Exception\UsageException;
use Msisf\Tests\Support\TemporaryFolder;
use PHPUnit\Framework\TestCase;

final class ConnectionSettingsTest extends TestCase
{
    private const PASSWORD = 'p4ss;w#rd "of" \'tests\' \\';

    private TemporaryFolder $folder;

    protected function setUp(): void
    {
        $this->folder = new TemporaryFolder();
    }

    public function testReadOptionFileOnlyItsClientGroupCounts(): void
    {
        $settings = $this->fromFile("# note\n[mysqld]\nuser=wrong\n[client]\nuser = me\nport=3307\nhost=db.example\nssl-ca=x\nquick\n[mysql]\nuser=other\n");
        self::assertSame(['me', 'msisf', 'mysql:host=db.example;port=3307;charset=utf8mb4'], [
            $settings->user, $settings->database, $settings->dataSource(),
        ]);
    }

    /** @dataProvider writtenPasswords */
    public function testReadOptionFileQuotesAndEscapesAreThoseOfTheClient(string $written, string $expected): void
    {
        self::assertSame($expected, $this->fromFile("[client]\nuser=me\npassword=$written\n")->password());
    }

    /** What "mariadb --print-defaults" of MariaDB 10.11 makes of these lines. */
    public static function writtenPasswords(): array
    {
        return [
            'plain' => ['abc', 'abc'],
            'quoted' => ['"a#b c"', 'a#b c'],
            'comment' => ['abc # of mine', 'abc'],
            'escape' => ['a\\\\b', 'a\\b'],
            'blank escape' => ['a\\sb', 'a b'],
            'equals' => ['a=b=c', 'a=b=c'],
            'empty' => ['', ''],
        ];
    }

    public function testReadEnvironmentFillsWhatTheFileLeavesOut(): void
    {
        file_put_contents($this->folder->path('my.cnf'), "[client]\nuser=me\n");
        $settings = ConnectionSettings::read($this->folder->path('my.cnf'), [
            'MSISF_DB_USER' => 'other', 'MSISF_DB_PASSWORD' => self::PASSWORD, 'MSISF_DB_SOCKET' => '/run/db.sock',
        ]);
        self::assertSame(['me', self::PASSWORD, '/run/db.sock'], [$settings->user, $settings->password(), $settings->socket]);
    }

    public function testDumpHasNoPassword(): void
    {
        $settings = ConnectionSettings::read(null, ['MSISF_DB_USER' => 'me', 'MSISF_DB_PASSWORD' => self::PASSWORD]);
        self::assertStringNotContainsString('p4ss', print_r($settings, true));
    }

    /** @dataProvider servers */
    public function testReadServerIsNamedAsItIsReached(array $environment, string $dataSource, string $server): void
    {
        $settings = ConnectionSettings::read(null, ['MSISF_DB_USER' => 'me', ...$environment]);

        self::assertSame([$dataSource, $server], [$settings->dataSource(), $settings->server()]);
    }

    public static function servers(): array
    {
        $socket = ['MSISF_DB_SOCKET' => '/run/db.sock'];

        return [
            'nothing said' => [[], 'mysql:host=localhost;charset=utf8mb4', 'localhost'],
            'the first port' => [['MSISF_DB_PORT' => '1'], 'mysql:host=localhost;port=1;charset=utf8mb4', 'localhost:1'],
            'the last port' => [['MSISF_DB_PORT' => '65535'], 'mysql:host=localhost;port=65535;charset=utf8mb4', 'localhost:65535'],
            'a socket goes before a host' => [[...$socket, 'MSISF_DB_HOST' => 'h'], 'mysql:unix_socket=/run/db.sock;charset=utf8mb4', '/run/db.sock'],
        ];
    }

    public function testReadLongestNameOfADatabaseIsAccepted(): void
    {
        $name = str_repeat('a_1', 21) . 'Z';

        self::assertSame($name, ConnectionSettings::read(null, ['MSISF_DB_USER' => 'me', 'MSISF_DB_DATABASE' => $name])->database);
    }

    public function testReadNoUserIsAUsageError(): void
    {
        $this->expectException(UsageException::class);
        $this->expectExceptionMessage('no database user');
        ConnectionSettings::read(null, []);
    }

    /** @dataProvider badEnvironments */
    public function testReadValuesThatWouldChangeTheConnectionAreRefused(array $environment, string $message): void
    {
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage($message);
        ConnectionSettings::read(null, ['MSISF_DB_USER' => 'me', ...$environment]);
    }

    public static function badEnvironments(): array
    {
        return [
            'another part of the source' => [['MSISF_DB_HOST' => 'a;unix_socket=/tmp/x'], 'database host'],
            'the same for the socket' => [['MSISF_DB_SOCKET' => '/tmp/x;dbname=y'], 'database socket'],
            'SQL in the name' => [['MSISF_DB_DATABASE' => 'a`; DROP DATABASE b; --'], 'database name'],
            'a line end in the name' => [['MSISF_DB_DATABASE' => "a\n"], 'database name'],
            'a name of 65 letters' => [['MSISF_DB_DATABASE' => str_repeat('a', 65)], 'database name'],
            'no name' => [['MSISF_DB_DATABASE' => ''], 'database name'],
            'port' => [['MSISF_DB_PORT' => '0'], 'database port'],
            'port too large' => [['MSISF_DB_PORT' => '65536'], 'database port'],
            'port with a tail' => [['MSISF_DB_PORT' => '3306;x'], 'database port'],
        ];
    }

    public function testReadFileThatOthersMayReadIsRefused(): void
    {
        file_put_contents($this->folder->path('my.cnf'), "[client]\nuser=me\npassword=secret\n");
        chmod($this->folder->path('my.cnf'), 0o644);
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage('other users may read it');
        ConnectionSettings::read($this->folder->path('my.cnf'), []);
    }

    public function testReadWrongLineIsNamedByNumberAndNotShown(): void
    {
        try {
            $this->fromFile("[client]\nuser=me\n=top-secret\n");
            self::fail('The file was accepted.');
        } catch (MsisfException $exception) {
            self::assertStringContainsString('line 3', $exception->getMessage());
            self::assertStringNotContainsString('top-secret', $exception->getMessage());
        }
    }

    private function fromFile(string $text): ConnectionSettings
    {
        $path = $this->folder->path('my.cnf');
        file_put_contents($path, $text);
        chmod($path, 0o600);

        return ConnectionSettings::read($path, []);
    }
}
