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
        self::assertSame(7, DatabaseFailure::wrap(null, static fn (): int => 7));
    }

    /** @dataProvider failures */
    public function testWrapFailureOfTheServerSaysWhatToDo(string $text, ?array $errorInfo, string $message): void
    {
        $this->expectException(ExternalPartException::class);
        $this->expectExceptionMessage($message);
        DatabaseFailure::wrap(null, static fn () => throw self::failure($text, $errorInfo));
    }

    public static function failures(): array
    {
        return [
            'with details' => [
                'SQLSTATE[42S02]: 1146 x', ['42S02', 1146, "Table 'msisf.ldem_4' doesn't exist"],
                "Table 'msisf.ldem_4' doesn't exist (error 1146). Import the elevation model first (ldem_mysql_insert.php).",
            ],
            'unknown number' => [
                'x', ['HY000', 9999, 'Odd. '], 'Odd (error 9999). The server\'s documentation explains the number.',
            ],
        ];
    }

    public function testWrapFailureToConnectNamesTheServerAndNotThePassword(): void
    {
        $settings = ConnectionSettings::read(null, [
            'MSISF_DB_HOST' => 'db.example', 'MSISF_DB_PORT' => '3307', 'MSISF_DB_USER' => 'me', 'MSISF_DB_PASSWORD' => 'p4ss',
        ]);
        try {
            DatabaseFailure::wrap($settings, static fn () => throw self::failure('SQLSTATE[HY000] [2002] Connection refused', null, 2002));
            self::fail('The failure was not passed on.');
        } catch (ExternalPartException $exception) {
            self::assertStringContainsString(
                'db.example:3307: Connection refused (error 2002). Is the server running, and are host, port or socket right?',
                $exception->getMessage(),
            );
            self::assertStringNotContainsString('p4ss', $exception->getMessage());
        }
    }

    public function testWrapOtherFailureIsPassedOn(): void
    {
        $this->expectException(RuntimeException::class);
        $this->expectExceptionMessage('ours');
        DatabaseFailure::wrap(null, static fn () => throw new RuntimeException('ours'));
    }

    private static function failure(string $text, ?array $errorInfo, int $code = 0): PDOException
    {
        $failure = new PDOException($text, $code);
        $failure->errorInfo = $errorInfo;

        return $failure;
    }
}
