<?php

declare(strict_types=1);

namespace Msisf\Tests\Unit\Ldem;

use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Ldem\PdsLabelParser;
use Msisf\Scripts\Ldem\PdsObject;
use Msisf\Scripts\Ldem\PdsUnit;
use PHPUnit\Framework\TestCase;

final class PdsObjectTest extends TestCase
{
    /** @dataProvider numbers */
    public function testRequiredNumberFormsOfNumbersAreRead(string $written, float $expected): void
    {
        self::assertSame($expected, self::object($written)->requiredNumber('A', PdsUnit::DEGREE));
    }

    public static function numbers(): array
    {
        return [
            'whole' => ['7', 7.0],
            'with a point behind it' => ['1737400.', 1737400.0],
            'with a point before it' => ['-.5', -0.5],
            'exponent' => ['+1.5E-3', 0.0015],
            'unit' => ['90 <deg>', 90.0],
            'unit in capitals' => ['90 <DEGREES>', 90.0],
        ];
    }

    /** @dataProvider wrongNumbers */
    public function testRequiredNumberAnythingElseIsRefused(string $written, string $message): void
    {
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage($message);
        self::object($written)->requiredNumber('A', PdsUnit::DEGREE);
    }

    public static function wrongNumbers(): array
    {
        return [
            'text' => ['many', 'x.LBL, line 2: A = many; a finite number is needed.'],
            'quoted' => ['"7"', 'A = 7; a finite number is needed'],
            'hexadecimal' => ['0x10', 'A = 0x10; a finite number'],
            'point alone' => ['.', 'A = .; a finite number'],
            'no digits of the exponent' => ['1e', 'A = 1e; a finite number'],
            'too large' => ['1E309', 'A = 1E309; a finite number'],
            'sequence' => ['(7)', 'A = (7); a finite number'],
            'another unit' => ['90 <rad>', 'A = 90 <rad>; the unit <deg> is needed.'],
        ];
    }

    /** @dataProvider integers */
    public function testRequiredIntegerLimitsBelongToTheRange(string $written, ?int $expected): void
    {
        if ($expected === null) {
            $this->expectException(BadInputException::class);
            $this->expectExceptionMessage("A = $written; a whole number from -2 to 9 is needed.");
        }
        self::assertSame($expected, self::object($written)->requiredInteger('A', -2, 9));
    }

    public static function integers(): array
    {
        return [['-2', -2], ['9', 9], ['9.0', 9], ['-3', null], ['10', null], ['8.5', null]];
    }

    public function testOptionalNumberMissingOrNotApplicableIsNull(): void
    {
        $object = self::object("'N/A'");

        self::assertNull($object->optionalNumber('A'));
        self::assertNull($object->optionalNumber('B'));
        self::assertNull($object->optionalInteger('B', 0, 1));
        self::assertSame(2.5, self::object('2.5')->optionalNumber('A'));
        self::assertSame(1, self::object('1')->optionalInteger('A', 0, 1));
    }

    /** @dataProvider wrongTexts */
    public function testRequiredTextMustBeOneText(string $written, string $message): void
    {
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage($message);
        self::object($written)->requiredText('A');
    }

    public static function wrongTexts(): array
    {
        return ['empty' => ['""', 'A = ; one text is needed'], 'sequence' => ['(a, b)', 'A = (a, b); one text is needed']];
    }

    public function testRequiredMissingKeywordIsNamedWithItsObject(): void
    {
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage('the label has no LINES.');
        self::object('1')->required('LINES');
    }

    public function testFindObjectFirstInTheOrderOfTheLabelHoweverDeep(): void
    {
        $label = PdsLabelParser::parse(
            "PDS_VERSION_ID = PDS3\nOBJECT = A\nOBJECT = IMAGE\nN = 1\nEND_OBJECT\nEND_OBJECT\nOBJECT = IMAGE\nN = 2\nEND_OBJECT\nEND",
            'x.LBL',
        );

        self::assertSame('1', $label->findObject('IMAGE')->requiredText('N'));
        self::assertSame('1', $label->findObject('image')->requiredText('n'));
        self::assertNull($label->findObject('B'));
    }

    public function testFindKeywordTwiceIsRefusedOnlyIfItDiffersAndIsAskedFor(): void
    {
        self::assertSame('2', self::object("1\nA = 3\nB = 2")->requiredText('B'));
        self::assertSame('1 <m>', self::object("1 <m>\nA = 1  <m>")->requiredText('A'));
        $this->expectException(BadInputException::class);
        $this->expectExceptionMessage('line 3: A = 1 <km>; line 2 of the same object says 1 <m>.');
        self::object("1 <m>\nA = 1 <km>")->find('A');
    }

    /** The label "A = ...". */
    private static function object(string $written): PdsObject
    {
        return PdsLabelParser::parse("PDS_VERSION_ID = PDS3\nA = $written\nEND", 'x.LBL');
    }
}
