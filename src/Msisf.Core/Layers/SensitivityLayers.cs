using Msisf.Core.Sensitivity;

namespace Msisf.Core.Layers;

/// <summary>The layers of an image's derivatives, which are written into a file of their own.</summary>
public static class SensitivityLayers
{
    /// <summary>The layers of some parameters.</summary>
    /// <param name="field">The derivatives: of radiance factors, or of electrons.</param>
    /// <param name="signal">What is differentiated, e.g. "electron"; empty for radiance factors.</param>
    public static LayerSet Of(SensitivityField field, IEnumerable<Parameter> parameters, string signal) => LayerSet.Of(
    [
        .. parameters.Select(parameter => new Layer(
            NameOf(parameter), LayerType.Real64, UnitOf(parameter, signal),
            $"Derivative of {(signal.Length == 0 ? "I/F" : "the mean number of electrons")}, averaged over the pixel's area, by the "
                + $"{parameter.Description}.",
            (row, _, values) => field.Of(parameter).AsSpan(row.Row * field.Width, field.Width).CopyTo(values))
        {
            CoversImage = true,
        }),
    ]);

    /// <summary>The name of a parameter's layer, e.g. "d-turn-x".</summary>
    public static string NameOf(Parameter parameter) => $"d-{parameter.Name}";

    private static string UnitOf(Parameter parameter, string signal) => (signal.Length, parameter.Unit) switch
    {
        (0, "1") => string.Empty,
        (0, var unit) => $"{SpelledUnit(unit)}-1",
        (_, "1") => signal,
        (_, var unit) => $"{signal} {SpelledUnit(unit)}-1",
    };

    /// <summary>As FITS and the other layers spell it.</summary>
    private static string SpelledUnit(string unit) => unit == "px" ? "pixel" : unit;
}
