<?php

declare(strict_types=1);

namespace Msisf\Scripts\Ldem;

use Msisf\Scripts\Exception\BadInputException;

/**
 * Reads a PDS3 label, attached or detached: nested objects, comments, texts, sequences and sets over several lines, units.
 * Planetary Data System Standards Reference 3.8, chapters 5 and 12.
 */
final class PdsLabelParser
{
    private const FIRST_KEYWORDS = ['PDS_VERSION_ID', 'CCSD3ZF0000100000001NJPL3IF0PDSX00000001'];

    /** Deeper than any label: a damaged file must not use up the stack. */
    private const DEPTH_LIMIT = 32;

    private readonly PdsTokenizer $tokens;

    private PdsToken $token;

    private int $depth = 0;

    private function __construct(string $text, private readonly string $file)
    {
        $this->tokens = new PdsTokenizer($text, $file);
        $this->token = $this->tokens->next();
    }

    /**
     * @param string $text the label; what follows its END (an attached image) is not looked at
     * @param string $file name for messages
     * @throws BadInputException the text is no PDS3 label; the message names file and line
     */
    public static function parse(string $text, string $file): PdsObject
    {
        $parser = new self($text, $file);
        if ($parser->token->kind !== PdsTokenKind::Word || !in_array(strtoupper($parser->token->text), self::FIRST_KEYWORDS, true)) {
            throw BadInputException::inFile(
                $file,
                'not a PDS3 label (it does not begin with PDS_VERSION_ID). Give the .LBL file that belongs to the elevation model.'
            );
        }
        $label = new PdsObject($file, 'the label', 1);
        $parser->readStatements($label, null);

        return $label;
    }

    private function readStatements(PdsObject $target, ?string $closing): void
    {
        if (++$this->depth > self::DEPTH_LIMIT) {
            throw $this->wrong($this->token, 'objects are nested too deep');
        }
        while (true) {
            $keyword = $this->take(PdsTokenKind::Word, 'a keyword');
            $word = strtoupper($keyword->text);
            if (in_array($word, ['END', 'END_OBJECT', 'END_GROUP'], true)) {
                $this->readEnd($keyword, $target, $closing);
                $this->depth--;

                return;
            }
            $this->takeSign('=', "'=' after $keyword->text");
            $value = $this->readValue();
            if ($word === 'OBJECT' || $word === 'GROUP') {
                $child = new PdsObject($this->file, $value->text, $keyword->line);
                $this->readStatements($child, 'END_' . $word);
                $target->addObject($child);
            } else {
                $target->addValue($keyword->text, $value);
            }
        }
    }

    private function readEnd(PdsToken $keyword, PdsObject $target, ?string $closing): void
    {
        $need = "$closing = $target->name is needed first (line $target->line opens it)";
        if (strtoupper($keyword->text) !== ($closing ?? 'END')) {
            throw $this->wrong($keyword, $closing === null ? 'no object is open here' : $need);
        }
        if ($closing !== null && $this->token->isSign('=')) {
            $this->advance();
            $name = $this->take(PdsTokenKind::Word, "an object's name");
            if (strcasecmp($name->text, $target->name) !== 0) {
                throw $this->wrong($name, $need);
            }
        }
    }

    private function readValue(): PdsValue
    {
        $line = $this->token->line;
        if ($this->token->isSign('(') || $this->token->isSign('{')) {
            $items = $this->readItems($this->token->text === '(' ? ')' : '}');

            return new PdsValue('', false, $this->takeUnit(), $items, $line);
        }
        if ($this->token->kind !== PdsTokenKind::Word && $this->token->kind !== PdsTokenKind::Quoted) {
            throw $this->wrong($this->token, 'a value is needed');
        }
        $text = $this->token;
        $this->advance();

        return new PdsValue(trim($text->text), $text->kind === PdsTokenKind::Quoted, $this->takeUnit(), null, $line);
    }

    /** @return list<PdsValue> */
    private function readItems(string $closing): array
    {
        if (++$this->depth > self::DEPTH_LIMIT) {
            throw $this->wrong($this->token, 'values are nested too deep');
        }
        $items = [];
        $this->advance();
        while (!$this->token->isSign($closing)) {
            if ($items !== []) {
                $this->takeSign(',', "',' or '$closing'");
            }
            $items[] = $this->readValue();
        }
        $this->advance();
        $this->depth--;

        return $items;
    }

    private function takeUnit(): ?string
    {
        if ($this->token->kind !== PdsTokenKind::Unit) {
            return null;
        }
        $unit = trim($this->token->text);
        $this->advance();

        return $unit;
    }

    private function take(PdsTokenKind $kind, string $need): PdsToken
    {
        $taken = $this->token->kind === $kind ? $this->token : throw $this->wrong($this->token, "$need is needed");
        // What follows END is another file's business: an attached image need not be text.
        if ($taken->kind !== PdsTokenKind::Word || $taken->text !== 'END') {
            $this->advance();
        }

        return $taken;
    }

    private function takeSign(string $sign, string $need): void
    {
        if (!$this->token->isSign($sign)) {
            throw $this->wrong($this->token, "$need is needed");
        }
        $this->advance();
    }

    private function advance(): void
    {
        $this->token = $this->tokens->next();
    }

    private function wrong(PdsToken $found, string $need): BadInputException
    {
        $what = $found->kind === PdsTokenKind::End ? 'the label ends' : "'" . substr($found->text, 0, 60) . "'";

        return BadInputException::atLine($this->file, $found->line, "$what; $need. Is this a whole PDS3 label?");
    }
}
