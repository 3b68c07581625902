using Msisf.App.Settings.Specs;

namespace Msisf.App.Settings;

/// <summary>The options of msis kernels.</summary>
internal static class KernelsOptions
{
    public static ChoiceSpec<bool> Format { get; } = new(
        "--format", OptionRole.WhatIsPrinted, [("table", false), ("json", true)],
        "A table for people, or an array of objects with all digits")
    {
        Default = false,
    };
}
