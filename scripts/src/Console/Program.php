<?php

declare(strict_types=1);

namespace Msisf\Scripts\Console;

use Closure;
use Msisf\Scripts\Exception\MsisfException;
use Throwable;

/** Runs an entry script: options in, exit code out. The one place where exceptions become exit codes. */
final class Program
{
    private const EXIT_BUG = 70;

    /**
     * @param list<string> $arguments with the script's name first, as in $argv
     * @param Closure(ParsedOptions, Output): void $body
     */
    public static function run(array $arguments, OptionParser $parser, Closure $body, ?Output $output = null): int
    {
        $scriptName = basename((string) array_shift($arguments));
        $output ??= Output::ofProcess($scriptName);
        try {
            $options = $parser->parse($arguments);
            if ($options->has('help')) {
                $output->result(rtrim($parser->help()));
            } else {
                $body($options, $output);
            }

            return 0;
        } catch (MsisfException $exception) {
            $output->error($exception->getMessage());

            return $exception->exitCode();
        } catch (Throwable $exception) {
            $output->error($exception::class . ': ' . $exception->getMessage() . '. This is a bug: please report it with these lines.');
            // The message of a foreign exception may name what it was called with; arguments are never in the trace.
            $output->detail($exception->getFile() . ':' . $exception->getLine() . "\n" . $exception->getTraceAsString());

            return self::EXIT_BUG;
        }
    }
}
