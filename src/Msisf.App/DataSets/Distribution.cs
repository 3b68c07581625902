using MathNet.Numerics.Distributions;
using Msisf.Adapters.Input;
using Msisf.App.Settings.Specs;

namespace Msisf.App.DataSets;

/// <summary>How a number of a data set's states is distributed; always within limits.</summary>
/// <param name="Kind">The word of the data set's file.</param>
internal sealed record Distribution(string Kind, IReadOnlyList<double> Numbers)
{
    /// <summary>What a distribution may look like, for messages.</summary>
    public const string ValidValues =
        "a number, [MIN, MAX], 'uniform MIN MAX', 'log-uniform MIN MAX' or 'normal MEAN SD MIN MAX'";

    private const string Constant = "constant";
    private const string Uniform = "uniform";
    private const string LogUniform = "log-uniform";
    private const string Gauss = "normal";

    /// <summary>Smallest number.</summary>
    public double Min => Numbers[^Math.Min(2, Numbers.Count)];

    /// <summary>Greatest number.</summary>
    public double Max => Numbers[^1];

    public static Distribution Of(double number) => new(Constant, [number]);

    /// <summary>All numbers of an interval alike.</summary>
    public static Distribution Of(double min, double max) => new(Uniform, [min, max]);

    /// <param name="values">The value of a key, or its list of two.</param>
    /// <param name="parse">Reads a number.</param>
    public static Distribution Parse(IReadOnlyList<string> values, Func<string, double> parse)
    {
        string[] words = [.. values.SelectMany(value => value.Split(' ', StringSplitOptions.RemoveEmptyEntries))];
        string kind = words[0] is Uniform or LogUniform or Gauss ? words[0] : values.Count > 1 ? Uniform : Constant;
        double[] numbers = [.. words.Skip(words[0] == kind ? 1 : 0).Select(parse)];
        int needed = kind switch { Constant => 1, Gauss => 4, _ => 2 };
        if (numbers.Length != needed)
        {
            throw new BadInputException($"{NumberText.Shown(string.Join(' ', values))} is not a distribution; {ValidValues} is needed");
        }

        Distribution distribution = new(kind, numbers);
        return kind == Constant || distribution.Min < distribution.Max
            ? (kind, numbers) switch
            {
                (LogUniform, [<= 0.0, ..]) => throw new BadInputException($"'{LogUniform}' needs numbers above 0"),
                (Gauss, [_, <= 0.0, ..]) => throw new BadInputException($"'{Gauss}' needs a standard deviation above 0"),
                (Gauss, _) when distribution.Reach <= 0.0 => throw new BadInputException(
                    $"'{Gauss}' has its limits so far from its mean that nothing is left. Move them nearer"),
                _ => distribution,
            }
            : throw new BadInputException("the first limit is not below the second. Swap them, or give a single number");
    }

    /// <summary>The number below which a part of all numbers lies.</summary>
    /// <param name="part">[0, 1).</param>
    public double Quantile(double part) => Kind switch
    {
        Constant => Min,
        Uniform => Min + (part * (Max - Min)),
        LogUniform => Math.Clamp(Min * Math.Exp(part * Math.Log(Max / Min)), Min, Max),
        _ => Math.Clamp(Normal.InvCDF(Numbers[0], Numbers[1], Below(Min) + (part * Reach)), Min, Max),
    };

    /// <summary>The part of all numbers that lies below one.</summary>
    public double PartBelow(double number) => number <= Min ? 0.0 : number >= Max ? 1.0 : Kind switch
    {
        LogUniform => Math.Log(number / Min) / Math.Log(Max / Min),
        Gauss => (Below(number) - Below(Min)) / Reach,
        _ => (number - Min) / (Max - Min),
    };

    /// <summary>As in the data set's file.</summary>
    public override string ToString() =>
        string.Join(' ', [.. Kind == Constant ? (string[])[] : [Kind], .. Numbers.Select(NumberSpec.TextOf)]);

    private double Reach => Below(Max) - Below(Min);

    private double Below(double number) => Normal.CDF(Numbers[0], Numbers[1], number);
}
