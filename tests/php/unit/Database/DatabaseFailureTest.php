<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Database;

use Msisf\Scripts\Database\ConnectionSettings;
use Msisf\Scripts\Database\DatabaseFailure;
use Msisf\Scripts\Exception\ExternalPartException;
use PDOException;
use PHPUnit\Framework\TestCase;
use RuntimeException;

final class DatabaseFailureTest extends TestCase
{
    public function testWrapGivesTheResultOfTheWork(): void
    {
        self::assertSame(7, DatabaseFailure::wrap('db:1', static fn (): int => 7));
    }

    /** @dataProvider failures */
    public function testWrapFailureOfTheServerSaysWhatToDo(string $text, ?array $errorInfo, string $message): void
    {
        $this->expectException(ExternalPartException::class);
        $this->expectExceptionMessage($message);
        DatabaseFailure::wrap('db:1', static fn () => throw self::failure($text, $errorInfo));
    }

    public static function failures(): array
    {
        return [
            'with details' => [
                'SQLSTATE[42S02]: 1146 x', ['42S02', 1146, "Table 'msisf.ldem_4' doesn't exist"],
                "database db:1: Table 'msisf.ldem_4' doesn't exist (error 1146). Import the elevation model first (ldem_mysql_insert.php).",
            ],
            'unknown number' => [
                'x', ['HY000', 9999, 'Odd. '], 'database db:1: Odd (error 9999). The server\'s documentation explains the number.',
            ],
        ];
    }

    public function testWrapFailureToConnectNamesTheServerAndNotThePassword(): void
    {
        $settings = ConnectionSettings::read(null, [
            'MSISF_DB_HOST' => 'db.example', 'MSISF_DB_PORT' => '3307', 'MSISF_DB_USER' => 'me', 'MSISF_DB_PASSWORD' => 'p4ss',
        ]);
        try {
            DatabaseFailure::wrapConnecting($settings, static fn () => throw self::failure('SQLSTATE[HY000] [2002] Connection refused', null, 2002));
            self::fail('The failure was not passed on.');
        } catch (ExternalPartException $exception) {
            self::assertStringContainsString(
                'database db.example:3307: Connection refused (error 2002). Is the server running, and are host, port or socket right?',
                $exception->getMessage(),
            );
            self::assertStringNotContainsString('p4ss', $exception->getMessage());
        }
    }

    /** @dataProvider failuresToConnect */
    public function testWrapFailureToConnectSaysWhatMayBeWrong(array $environment, string $text, int $number, string $message): void
    {
        $settings = ConnectionSettings::read(null, ['MSISF_DB_USER' => 'me', ...$environment]);
        $this->expectException(ExternalPartException::class);
        $this->expectExceptionMessage($message);
        DatabaseFailure::wrapConnecting($settings, static fn () => throw self::failure("SQLSTATE[HY000] [$number] $text", null, $number));
    }

    public static function failuresToConnect(): array
    {
        $host = ['MSISF_DB_HOST' => 'db'];
        $encrypted = [...$host, 'MSISF_DB_SSL_MODE' => 'REQUIRED'];

        return [
            'another service' => [$host, 'MySQL server has gone away', 2006, 'Is it a MySQL or MariaDB server that answers there?'],
            'the server dies' => [['MSISF_DB_SOCKET' => '/run/db.sock'], 'MySQL server has gone away', 2006, 'The server has gone away: restart it'],
            'no TLS there' => [$encrypted, 'MySQL server has gone away', 2006, 'Does the server have TLS'],
            'a wrong certificate' => [$encrypted, 'Cannot connect to MySQL using SSL', 2002, 'Does the server have TLS'],
            'no server, with TLS' => [$encrypted, 'Connection refused', 2002, 'Is the server running'],
            'root by the socket' => [$host, "Access denied for user 'root'@'localhost'", 1698, 'This user logs in by the socket'],
        ];
    }

    public function testWrapOtherFailureIsPassedOn(): void
    {
        $this->expectException(RuntimeException::class);
        $this->expectExceptionMessage('ours');
        DatabaseFailure::wrap('db:1', static fn () => throw new RuntimeException('ours'));
    }

    private static function failure(string $text, ?array $errorInfo, int $code = 0): PDOException
    {
        $failure = new PDOException($text, $code);
        $failure->errorInfo = $errorInfo;

        return $failure;
    }
}
