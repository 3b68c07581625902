<?php

declare(strict_types=1);

namespace Msisf\Tests\Integration;

use Msisf\Tests\Support\LabelText;
use Msisf\Tests\Support\Parts;
use Msisf\Tests\Support\PrivateServer;
use Msisf\Tests\Support\ScriptRun;
use Msisf\Tests\Support\TemporaryFolder;
use PHPUnit\Framework\TestCase;

/** ldem_mysql_insert.php on small products, in a database of its own in the private server. */
abstract class ImportTestCase extends TestCase
{
    /** Over all columns of all rows, in any order. */
    private const CHECKSUM = "BIT_XOR(CRC32(CONCAT_WS('/', row_index, col_index, latitude, longitude, planetary_radius, x, y, z, HEX(`point`))))";

    protected TemporaryFolder $folder;

    /** @var array<string, string> the connection */
    protected array $environment;

    protected function setUp(): void
    {
        $this->folder = new TemporaryFolder();
        $this->environment = PrivateServer::shared()->freshDatabase();
    }

    /** A product of 20 lines of 40 samples, from 20 to 15 degrees north and from 30 to 40 degrees east. */
    protected function smallProduct(int $seed = 1, string $productId = 'SMALL'): string
    {
        return LabelText::writeProduct($this->folder, $productId, [20, 15, 30, 40], LabelText::samples(800, $seed));
    }

    /** @param list<string> $arguments */
    protected function start(array $arguments, array $environment = []): ScriptRun
    {
        $script = Parts::root() . '/scripts/ldem_mysql_insert.php';

        return ScriptRun::start([PHP_BINARY, $script, ...$arguments], [...$this->environment, ...$environment]);
    }

    /** @param list<string> $arguments */
    protected function import(array $arguments, array $environment = []): ScriptRun
    {
        return $this->start($arguments, $environment)->wait();
    }

    protected function value(string $sql): mixed
    {
        return PrivateServer::shared()->value($this->environment, $sql);
    }

    protected function execute(string $sql): void
    {
        PrivateServer::shared()->execute($this->environment, $sql);
    }

    /** @param array<string, string>|null $environment the connection, if it is not the test's own */
    protected function checksum(string $where = '1 = 1', ?array $environment = null): string
    {
        $sql = 'SELECT CONCAT(COUNT(*), \' \', ' . self::CHECKSUM . ") FROM ldem_4 WHERE $where";

        return (string) PrivateServer::shared()->value($environment ?? $this->environment, $sql);
    }

    protected static function assertDone(ScriptRun $run): void
    {
        self::assertSame(0, $run->exitCode, $run->errors);
    }

    /** Asserts that the run was refused: exit code, one line of error that says why, nothing on stdout. */
    protected static function assertRefused(int $exitCode, string $message, ScriptRun $run): void
    {
        self::assertSame([$exitCode, ''], [$run->exitCode, $run->output], $run->errors);
        self::assertSame(1, preg_match_all('/^ldem_mysql_insert\.php: error: .+$/m', $run->errors), $run->errors);
        self::assertStringContainsString($message, $run->errors);
    }
}
