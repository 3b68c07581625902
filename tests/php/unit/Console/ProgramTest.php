<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Console;

use Closure;
use Msisf\Scripts\Console\OptionParser;
use Msisf\Scripts\Console\Output;
use Msisf\Scripts\Console\Program;
use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Exception\ExternalPartException;
use Msisf\Scripts\Exception\NothingToDoException;
use Msisf\Scripts\Exception\UsageException;
use PHPUnit\Framework\TestCase;
use RuntimeException;
use SensitiveParameter;

final class ProgramTest extends TestCase
{
    /** @dataProvider failures */
    public function testRunExpectedFailureIsOneLineAndItsExitCode(string $class, int $exitCode): void
    {
        [$code, $results, $messages] = self::runBody(static fn () => throw new $class("two\nlines"));
        self::assertSame([$exitCode, '', "script.php: error: two lines\n"], [$code, $results, $messages]);
    }

    public static function failures(): array
    {
        return [[UsageException::class, 1], [BadInputException::class, 2], [ExternalPartException::class, 3], [NothingToDoException::class, 4]];
    }

    public function testRunBugIsSeventyWithAStackButNoArguments(): void
    {
        $fail = static fn (#[SensitiveParameter] string $password): never => throw new RuntimeException('broken');
        [$code, $results, $messages] = self::runBody(static function () use ($fail): void {
            $fail('Tr0ub4dor-and-3');
        });
        self::assertSame([70, ''], [$code, $results]);
        self::assertStringContainsString('RuntimeException: broken. This is a bug: please report it', $messages);
        self::assertStringContainsString('ProgramTest.php', $messages);
        self::assertStringNotContainsString('Tr0ub4dor', $messages);
    }

    public function testRunWarningOfPhpIsABug(): void
    {
        [$code, , $messages] = self::runBody(static function (): void {
            [][0];
        });
        self::assertSame(70, $code);
        self::assertStringContainsString('Undefined array key', $messages);
    }

    public function testRunResultsAndNoticesGoTheirOwnWays(): void
    {
        [$code, $results, $messages] = self::runBody(static function ($options, Output $output): void {
            $output->result('done');
            $output->notice('working');
        });
        self::assertSame([0, "done\n", "script.php: working\n"], [$code, $results, $messages]);
    }

    /** @return array{int, string, string} exit code, results, messages */
    private static function runBody(Closure $body): array
    {
        $results = fopen('php://memory', 'w+');
        $messages = fopen('php://memory', 'w+');
        $output = new Output('script.php', $results, $messages);
        $code = Program::run(['folder/script.php'], new OptionParser('usage', []), $body, $output);

        return [$code, (string) stream_get_contents($results, null, 0), (string) stream_get_contents($messages, null, 0)];
    }
}
