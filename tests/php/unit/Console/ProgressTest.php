<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Console;

use Msisf\Scripts\Console\Output;
use Msisf\Scripts\Console\Progress;
use PHPUnit\Framework\TestCase;

/** On a stream that is no terminal; the speeds depend on the machine. */
final class ProgressTest extends TestCase
{
    public function testReachWithinTheFirstSecondsTellsNothing(): void
    {
        self::assertSame('', self::told(static function (Progress $progress): void {
            $progress->reach(10);
            $progress->reach(50);
        }));
    }

    public function testFinishTellsWhatThisRunHasDone(): void
    {
        $told = self::told(static function (Progress $progress): void {
            $progress->reach(60);
            $progress->finish();
        });

        // 20 of the 60 were there before.
        self::assertMatchesRegularExpression('~^script\.php: 40 rows in [0-9]\.[0-9] s, [0-9]+/s\n$~', $told);
    }

    public function testFinishWithoutWorkTellsNone(): void
    {
        self::assertMatchesRegularExpression(
            '~^script\.php: 0 rows in 0\.[0-9] s, 0/s\n$~',
            self::told(static fn (Progress $progress) => $progress->finish()),
        );
    }

    /** @param callable(Progress): void $work */
    private static function told(callable $work): string
    {
        $messages = fopen('php://memory', 'w+');
        $work(new Progress(new Output('script.php', fopen('php://memory', 'w+'), $messages), 'rows', 100, 20));
        rewind($messages);

        return stream_get_contents($messages);
    }
}
