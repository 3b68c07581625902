<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Console;

use Msisf\Scripts\Console\Option;
use Msisf\Scripts\Console\OptionParser;
use Msisf\Scripts\Console\ParsedOptions;
use Msisf\Scripts\Exception\UsageException;
use PHPUnit\Framework\TestCase;

final class OptionParserTest extends TestCase
{
    public function testParseBothFormsOfAValueAreRead(): void
    {
        self::assertSame('7', self::parse('--count', '7')->text('count'));
        self::assertSame('a=b', self::parse('--name=a=b')->text('name'));
        self::assertSame('-5', self::parse('--count', '-5')->text('count'));
    }

    public function testParseDefaultStandsInForAMissingOption(): void
    {
        self::assertSame(3, self::parse()->integer('count', 0, 9));
        self::assertNull(self::parse()->text('name'));
        self::assertFalse(self::parse()->has('fast'));
    }

    public function testParseAfterTwoDashesEverythingIsAnOperand(): void
    {
        self::assertSame(['a', '--fast'], self::parse('a', '--', '--fast')->operands);
    }

    /** @dataProvider operands */
    public function testParseArgumentsWithoutDashesAreOperands(array $arguments, array $expected): void
    {
        self::assertSame($expected, self::parse(...$arguments)->operands);
    }

    public static function operands(): array
    {
        return [
            'between options' => [['a', '--fast', 'b'], ['a', 'b']],
            'standard input' => [['-'], ['-']],
            'empty' => [[''], ['']],
            'two dashes twice' => [['--', '--', 'a'], ['--', 'a']],
            'two dashes alone' => [['--'], []],
        ];
    }

    public function testParseOperandWhereThereAreNoneIsRefused(): void
    {
        $this->expectException(UsageException::class);
        $this->expectExceptionMessage("'a' is not an option. --help lists the options.");
        (new OptionParser('usage', []))->parse(['a']);
    }

    public function testParseValueMayBeEmptyOrADash(): void
    {
        self::assertSame('', self::parse('--name=')->text('name'));
        self::assertSame('', self::parse('--name', '')->text('name'));
        self::assertSame('-', self::parse('--name', '-')->text('name'));
        self::assertSame('--fast', self::parse('--name=--fast')->text('name'));
        self::assertTrue(self::parse('--name=')->has('name'));
    }

    /** @dataProvider wrongArguments */
    public function testParseWrongArgumentsAreRefusedByName(array $arguments, string $message): void
    {
        $this->expectException(UsageException::class);
        $this->expectExceptionMessage($message);
        self::parse(...$arguments)->integer('count', 0, 9);
    }

    public static function wrongArguments(): array
    {
        return [
            'unknown' => [['--fats'], '--fats is not an option'],
            'one dash' => [['-fast'], '-fast is not an option'],
            'abbreviated' => [['--cou=1'], '--cou is not an option'],
            'twice' => [['--fast', '--fast'], '--fast is given twice'],
            'twice in two forms' => [['--count=1', '--count', '1'], '--count is given twice'],
            'no name' => [['--=1'], '-- is not an option'],
            'help with a value' => [['--help=1'], '--help=1: this option has no value'],
            'no value' => [['--count'], '--count is missing'],
            'an option as value' => [['--count', '--fast'], '--count has no value'],
            'a flag with a value' => [['--fast=1'], '--fast=1: this option has no value'],
            'too large' => [['--count=10'], '--count=10: a whole number from 0 to 9 is needed'],
            'no number' => [['--count=1e1'], '--count=1e1: a whole number'],
            'a line end' => [["--count=1\n"], 'a whole number from 0 to 9'],
        ];
    }

    public function testHelpNamesEveryOptionAndDefault(): void
    {
        $help = self::parser()->help();
        self::assertMatchesRegularExpression('/^  --count N +How many\. \(default: 3\)$/m', $help);
        self::assertMatchesRegularExpression('/^  --help +Show this text\.$/m', $help);
    }

    public function testHelpLongNamesAndTextsGoOnInLinesOfTheirOwn(): void
    {
        $help = (new OptionParser('usage', [
            Option::value('name-of-an-option', 'LONG-VALUE', 'Short.'),
            Option::value('list', 'A', str_repeat('word ', 20), 'end'),
        ]))->help();

        self::assertStringContainsString("  --name-of-an-option LONG-VALUE\n" . str_repeat(' ', 30) . "Short.\n", $help);
        self::assertMatchesRegularExpression('/^ {30}(word )+ \(default: end\)$/m', $help);
        self::assertLessThanOrEqual(100, max(array_map('strlen', explode("\n", $help))));
    }

    private static function parse(string ...$arguments): ParsedOptions
    {
        return self::parser()->parse($arguments);
    }

    private static function parser(): OptionParser
    {
        return new OptionParser('usage', [
            Option::value('count', 'N', 'How many.', '3'),
            Option::value('name', 'TEXT', 'What.'),
            Option::flag('fast', 'Hurry.'),
        ], 'FILE');
    }
}
