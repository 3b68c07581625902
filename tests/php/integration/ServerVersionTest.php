<?php

declare(strict_types=1);

namespace Msisf\Tests\Integration;

use Msisf\Tests\Support\LabelText;
use Msisf\Tests\Support\Parts;
use Msisf\Tests\Support\ScriptRun;
use Msisf\Tests\Support\TemporaryFolder;
use PHPUnit\Framework\TestCase;

final class ServerVersionTest extends TestCase
{
    /** @dataProvider versions */
    public function testImportServerOfAnotherVersionIsRefused(string $version, string $message): void
    {
        $folder = new TemporaryFolder();
        $socket = $folder->path('socket');
        $server = ScriptRun::start([PHP_BINARY, dirname(__DIR__) . '/support/fake_server.php', $socket, $version]);
        while (!file_exists($socket) && $server->isRunning()) {
            usleep(2000);
        }
        $label = LabelText::writeProduct($folder, 'SMALL', [20, 15, 30, 40], LabelText::samples(800));
        $run = ScriptRun::start(
            [PHP_BINARY, Parts::root() . '/scripts/ldem_mysql_insert.php', $label],
            ['MSISF_DB_SOCKET' => $socket, 'MSISF_DB_USER' => 'me', 'MSISF_DB_PASSWORD' => 'Tr0ub4dor-and-3'],
        )->wait();
        $server->kill();
        $server->wait();
        self::assertSame([3, ''], [$run->exitCode, $run->output], $run->errors);
        self::assertSame("ldem_mysql_insert.php: error: database: $message\n", $run->errors);
    }

    public static function versions(): array
    {
        $need = 'MariaDB 10.5 or MySQL 8.0, or later, is needed. Update the server.';

        return [
            'old MySQL' => ['5.7.44-log', "MySQL 5.7.44 is too old; $need"],
            'old MariaDB' => ['5.5.5-10.3.39-MariaDB-0ubuntu', "MariaDB 10.3.39 is too old; $need"],
            'something else' => ['TiDB-v7', "the server says that its version is 'TiDB-v7'; $need"],
        ];
    }
}
