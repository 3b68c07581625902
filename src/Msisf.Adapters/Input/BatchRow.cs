namespace Msisf.Adapters.Input;

/// <summary>One line of a batch file with named columns.</summary>
internal sealed class BatchRow(BatchColumns columns, string[] values)
{
    /// <summary>Whether there is a column.</summary>
    public bool Has(string name) => columns.Has(name);

    /// <summary>The number in a column.</summary>
    /// <exception cref="BadInputException">It is none; the message begins with the column's name.</exception>
    public double Number(string name) => Read(name, text => NumberText.TryParse(text, out double number)
        ? number
        : throw new BadInputException($"{NumberText.ProblemWith(text)}."));

    /// <summary>The numbers in several columns.</summary>
    /// <exception cref="BadInputException">One is none; the message begins with the column's name.</exception>
    public double[] Numbers(IReadOnlyList<string> names) => [.. names.Select(Number)];

    /// <summary>What stands in a column.</summary>
    /// <exception cref="BadInputException">It is wrong; the message begins with the column's name.</exception>
    public T Read<T>(string name, Func<string, T> parse)
    {
        (int index, string written) = columns.Of(name);
        try
        {
            return parse(values[index]);
        }
        catch (BadInputException exception)
        {
            throw new BadInputException($", column {written}: {exception.Message}", exception);
        }
    }
}
