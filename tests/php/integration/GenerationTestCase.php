<?php

declare(strict_types=1);

namespace Msisf\Tests\Integration;

use Msisf\Tests\Support\Parts;
use Msisf\Tests\Support\ReferencePatterns;
use Msisf\Tests\Support\ScriptRun;
use Msisf\Tests\Support\TemporaryFolder;
use PHPUnit\Framework\TestCase;

/** generate_pattern.php on the real LDEM_4 in the private server. */
abstract class GenerationTestCase extends TestCase
{
    /** Half of the Moon: enough where other tests compare all of it. */
    protected const NORTH = ['--lat=0:90'];

    private const PATTERNS_OF_NORTH = 1296;

    protected TemporaryFolder $folder;

    /** @var array<string, string> the connection */
    protected array $environment;

    protected function setUp(): void
    {
        $this->folder = new TemporaryFolder();
        $this->environment = ImportedModels::ldem4();
    }

    /** @param list<string> $arguments */
    protected function start(array $arguments, array $environment = []): ScriptRun
    {
        $script = Parts::root() . '/scripts/generate_pattern.php';

        return ScriptRun::start([PHP_BINARY, $script, ...$arguments], [...$this->environment, ...$environment]);
    }

    /** @param list<string> $arguments */
    protected function generate(array $arguments, array $environment = []): ScriptRun
    {
        return $this->start($arguments, $environment)->wait();
    }

    /** Asserts that the run was refused: exit code, one line that says why, nothing on stdout. */
    protected static function assertRefused(int $exitCode, string $message, ScriptRun $run): void
    {
        self::assertSame([$exitCode, ''], [$run->exitCode, $run->output], $run->errors);
        self::assertMatchesRegularExpression('/^generate_pattern\.php: error: [^\n]+\n$/D', $run->errors);
        self::assertStringContainsString($message, $run->errors);
    }

    /** Asserts that a repository has all patterns of the real LDEM_4 as msis makes them, and nothing else. */
    protected static function assertAllPatternsOfMsis(string $repository): void
    {
        self::assertSame([], ReferencePatterns::ldem4()->differencesIn($repository, wantAll: true));
    }

    /** The same of a repository that has those of the northern half, and nothing else. */
    protected static function assertNorthernPatternsOfMsis(string $repository): void
    {
        self::assertSame([], ReferencePatterns::ldem4()->differencesIn($repository, wantAll: false));
        self::assertCount(self::PATTERNS_OF_NORTH, preg_grep('/_lat_\d.*(?<!\.partial)\.inc$/', scandir("$repository/4")));
        self::assertSame([], glob("$repository/4/*_lat_-*"));
    }
}
