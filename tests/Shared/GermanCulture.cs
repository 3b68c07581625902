using System.Globalization;
using System.Runtime.CompilerServices;

namespace Msisf.TestSupport;

/// <summary>Every test runs with decimal commas, so that a forgotten invariant culture fails.</summary>
internal static class GermanCulture
{
    [ModuleInitializer]
    internal static void Set()
    {
        CultureInfo.DefaultThreadCurrentCulture = CultureInfo.GetCultureInfo("de-DE");
        CultureInfo.CurrentCulture = CultureInfo.DefaultThreadCurrentCulture;
    }
}
