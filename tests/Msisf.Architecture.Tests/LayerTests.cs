using System.Reflection;
using System.Reflection.Metadata;
using System.Reflection.PortableExecutable;
using Xunit;

namespace Msisf.Architecture.Tests;

/// <summary>Cli and Server use App uses Adapters and MySql use Core, never back; Core is pure; native calls live in one namespace.</summary>
public sealed class LayerTests
{
    /// <summary>The compiler puts it into every iterator method.</summary>
    private const string UsedByEachIterator = "System.Environment.get_CurrentManagedThreadId";

    private static readonly Assembly Core = Assembly.Load("Msisf.Core");
    private static readonly Assembly[] Own = [.. (
        (string[])["Msisf.Core", "Msisf.Synthesis", "Msisf.Adapters", "Msisf.MySql", "Msisf.App", "msis", "msis-server"]).Select(Assembly.Load)];

    /// <summary>Each names all that it may use of ours, and uses it: a reference that nothing needs is not in the assembly.</summary>
    [Theory]
    [InlineData("Msisf.Core", "")]
    [InlineData("Msisf.Synthesis", "Msisf.Core")]
    [InlineData("Msisf.Adapters", "Msisf.Core Msisf.Synthesis")]
    [InlineData("Msisf.MySql", "Msisf.Core")]
    [InlineData("Msisf.App", "Msisf.Adapters Msisf.Core Msisf.MySql")]
    public void Assemblies_Reference_OnlyLayersBelow(string name, string expected) =>
        Assert.Equal(expected, string.Join(' ', ReferencesOf(Assembly.Load(name)).Where(IsOurs).Order(StringComparer.Ordinal)));

    [Theory]
    [InlineData("msis")]
    [InlineData("msis-server")]
    public void Programs_DoNotReference_EachOther(string name) =>
        Assert.DoesNotContain(ReferencesOf(Assembly.Load(name)), other => other is "msis" or "msis-server");

    /// <summary>Starting ASP.NET Core would slow down every call of msis.</summary>
    [Fact]
    public void AspNetCore_IsUsed_InTheServerOnly() =>
        Assert.Equal(
            ["msis-server"],
            Own.Where(assembly => ReferencesOf(assembly).Any(name => name.StartsWith("Microsoft.AspNetCore", StringComparison.Ordinal)))
                .Select(assembly => assembly.GetName().Name));

    [Fact]
    public void Cli_References_TheApplication() => Assert.Contains("Msisf.App", ReferencesOf(Assembly.Load("msis")));

    [Theory]
    [InlineData("System.CommandLine")]
    [InlineData("Spectre.Console")]
    public void CommandLineLibraries_AreUsed_InCliOnly(string library) =>
        Assert.Equal(["msis"], Own.Where(assembly => ReferencesOf(assembly).Contains(library)).Select(assembly => assembly.GetName().Name));

    [Fact]
    public void Core_References_OnlyTheRuntimeAndMathNet() =>
        Assert.All(Core.GetReferencedAssemblies(), name => Assert.True(
            name.Name!.StartsWith("System.", StringComparison.Ordinal) || name.Name is "MathNet.Numerics",
            $"Core references {name.Name}"));

    [Theory]
    [InlineData("System.IO.File")]
    [InlineData("System.IO.FileStream")]
    [InlineData("System.IO.Directory")]
    [InlineData("System.Environment")]
    [InlineData("System.Diagnostics.Process")]
    [InlineData("System.Console")]
    [InlineData("System.TimeProvider")]
    [InlineData("System.Random")]
    [InlineData("System.Net.Http.HttpClient")]
    public void CoreAndSynthesis_DoNotUse_TheWorld(string forbidden) =>
        Assert.DoesNotContain(
            MembersUsedBy(Core).Concat(MembersUsedBy(Assembly.Load("Msisf.Synthesis"))),
            member => member.StartsWith($"{forbidden}.", StringComparison.Ordinal) && member != UsedByEachIterator);

    [Fact]
    public void NativeCalls_Live_InTheInteropNamespaceOnly()
    {
        IEnumerable<MethodInfo> native =
            from assembly in Own
            from type in assembly.GetTypes()
            from method in type.GetMethods(
                BindingFlags.Static | BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly)
            where method.Attributes.HasFlag(MethodAttributes.PinvokeImpl)
            select method;

        MethodInfo[] found = [.. native];
        Assert.NotEmpty(found);
        Assert.All(found, method => Assert.StartsWith("Msisf.Adapters.Interop", method.DeclaringType!.FullName, StringComparison.Ordinal));
    }

    private static bool IsOurs(string name) => name.StartsWith("Msisf.", StringComparison.Ordinal) || name == "msis";

    private static IEnumerable<string> ReferencesOf(Assembly assembly) => assembly.GetReferencedAssemblies().Select(name => name.Name!);

    private static IReadOnlyList<string> MembersUsedBy(Assembly assembly)
    {
        using FileStream stream = File.OpenRead(assembly.Location);
        using PEReader image = new(stream);
        MetadataReader reader = image.GetMetadataReader();
        return
        [
            .. from handle in reader.MemberReferences
               let member = reader.GetMemberReference(handle)
               where member.Parent.Kind == HandleKind.TypeReference
               let type = reader.GetTypeReference((TypeReferenceHandle)member.Parent)
               select $"{reader.GetString(type.Namespace)}.{reader.GetString(type.Name)}.{reader.GetString(member.Name)}",
        ];
    }
}
