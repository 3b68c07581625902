<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Database;

use Msisf\Scripts\Database\ConnectionSettings;
use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Exception\MsisfException;
use Msisf\Scripts\Exception\UsageException;
use Msisf\Tests\Support\OptionFileCases;
use Msisf\Tests\Support\TemporaryFolder;
use PDO;
use PHPUnit\Framework\TestCase;

final class ConnectionSettingsTest extends TestCase
{
    private const PASSWORD = 'p4ss;w#rd "of" \'tests\' \\';

    private TemporaryFolder $folder;

    protected function setUp(): void
    {
        $this->folder = new TemporaryFolder();
    }

    /** @dataProvider connections */
    public function testReadOptionFileIsTheConnectionOfTheTable(string $name): void
    {
        $settings = $this->fromTable($name);
        $isDefault = $settings->socket === ConnectionSettings::defaultSocket(ConnectionSettings::DEFAULT_SOCKETS);
        self::assertSame(
            $this->inFolder(OptionFileCases::expected($name)),
            [
                'user' => $settings->user,
                'password' => $settings->password(),
                'database' => $settings->database,
                'host' => $settings->host,
                'port' => $settings->port,
                'socket' => $isDefault ? 'default' : $settings->socket,
                'tls' => $settings->tls->mode->value,
                'ca' => $settings->tls->certificateAuthority,
                'unverified' => $settings->isUnverified(),
            ],
        );
    }

    public static function connections(): array
    {
        return OptionFileCases::names(areRefused: false);
    }

    /** @dataProvider refused */
    public function testReadOptionFileIsRefusedWithTheMessageOfTheTable(string $name): void
    {
        try {
            $this->fromTable($name);
            self::fail('The file was accepted.');
        } catch (MsisfException $exception) {
            self::assertStringContainsString($this->inFolder(OptionFileCases::of($name)['refused']), $exception->getMessage());
            self::assertStringNotContainsString('secret', $exception->getMessage());
        }
    }

    public static function refused(): array
    {
        return OptionFileCases::names(areRefused: true);
    }

    public function testDefaultSocketIsTheFirstThatIsThere(): void
    {
        self::assertSame(OptionFileCases::defaultSockets(), ConnectionSettings::DEFAULT_SOCKETS);
        [$one, $there, $other] = array_map($this->folder->path(...), ['a', 'there', 'b']);
        touch($there);
        self::assertSame($there, ConnectionSettings::defaultSocket([$one, $there, $other]));
        self::assertSame($one, ConnectionSettings::defaultSocket([$one, $other]));
    }

    /** @dataProvider tlsOptions */
    public function testTlsIsWhatPdoCallsIt(string $option, array $expected): void
    {
        touch($this->folder->path('ca.pem'));
        $settings = $this->fromFile($this->inFolder("[client]\nuser=me\nhost=db\n$option\n"));
        self::assertEquals($this->inFolder($expected), $settings->tls->pdoOptions());
    }

    public static function tlsOptions(): array
    {
        $verify = PDO::MYSQL_ATTR_SSL_VERIFY_SERVER_CERT;

        return [
            'nothing' => ['', []],
            'none' => ['ssl-mode=DISABLED', []],
            'encrypted' => ['ssl-mode=REQUIRED', [$verify => false, PDO::MYSQL_ATTR_SSL_CIPHER => 'DEFAULT']],
            'by the system' => ['ssl-mode=VERIFY_IDENTITY', [$verify => true, PDO::MYSQL_ATTR_SSL_CIPHER => 'DEFAULT']],
            'by an authority' => ['ssl-ca={folder}/ca.pem', [$verify => true, PDO::MYSQL_ATTR_SSL_CA => '{folder}/ca.pem']],
        ];
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
            'the first port' => [['MSISF_DB_HOST' => 'db', 'MSISF_DB_PORT' => '1'], 'mysql:host=db;port=1;charset=utf8mb4', 'db:1'],
            'the last port' => [['MSISF_DB_HOST' => '::1', 'MSISF_DB_PORT' => '65535'], 'mysql:host=::1;port=65535;charset=utf8mb4', '::1:65535'],
            'no port' => [['MSISF_DB_HOST' => 'db'], 'mysql:host=db;charset=utf8mb4', 'db'],
            'a socket' => [$socket, 'mysql:unix_socket=/run/db.sock;charset=utf8mb4', '/run/db.sock'],
            'a socket and a port' => [[...$socket, 'MSISF_DB_PORT' => '1'], 'mysql:unix_socket=/run/db.sock;charset=utf8mb4', '/run/db.sock'],
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
        ConnectionSettings::read(null, []);
    }

    public function testReadLineEndInANameIsRefused(): void
    {
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage('database name');
        ConnectionSettings::read(null, ['MSISF_DB_USER' => 'me', 'MSISF_DB_DATABASE' => "a\n"]);
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

    private function fromTable(string $name): ConnectionSettings
    {
        touch($this->folder->path('ca.pem'));
        $case = $this->inFolder(OptionFileCases::of($name));

        return $this->fromFile(implode("\n", $case['file']), $case['environment'] ?? []);
    }

    /** Puts the test's folder in place of {folder}, in a text or in all of a list. */
    private function inFolder(mixed $value): mixed
    {
        return match (true) {
            is_array($value) => array_map($this->inFolder(...), $value),
            is_string($value) => str_replace('{folder}', rtrim($this->folder->path(''), '/'), $value),
            default => $value,
        };
    }

    private function fromFile(string $text, array $environment = []): ConnectionSettings
    {
        $path = $this->folder->path('my.cnf');
        file_put_contents($path, $text);
        chmod($path, 0o600);

        return ConnectionSettings::read($path, $environment);
    }
}
