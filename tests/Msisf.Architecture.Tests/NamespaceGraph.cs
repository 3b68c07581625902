using System.Reflection;
using System.Reflection.Emit;
using System.Runtime.CompilerServices;

namespace Msisf.Architecture.Tests;

/// <summary>
/// Which namespaces use which others: in base types, interfaces, attributes, fields, signatures, local variables and the instructions of
/// methods. A.B and A.B.C are two namespaces as any others. A constant of another namespace is not seen, because the compiler copies it.
/// </summary>
internal sealed class NamespaceGraph
{
    private const BindingFlags All =
        BindingFlags.Static | BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    private static readonly Dictionary<short, OpCode> OpCodesByValue = typeof(OpCodes)
        .GetFields(BindingFlags.Public | BindingFlags.Static)
        .Select(field => (OpCode)field.GetValue(null)!)
        .ToDictionary(code => code.Value);

    private readonly SortedDictionary<string, SortedDictionary<string, string>> _uses = new(StringComparer.Ordinal);
    private readonly HashSet<string> _own;

    /// <summary>Reads some types.</summary>
    /// <param name="types">Only what they use of each other's namespaces counts.</param>
    public NamespaceGraph(IEnumerable<Type> types)
    {
        Type[] own = [.. types.Where(type => type.Namespace is not null)];
        _own = [.. own.Select(type => type.Namespace!)];
        foreach (Type type in own)
        {
            foreach (Type used in UsedBy(type).SelectMany(Parts))
            {
                Add(type, used);
            }
        }
    }

    /// <summary>Each use of a namespace by another, with a type of each: "A -> B", "by user's used".</summary>
    public IEnumerable<(string User, string Used, string By)> Uses =>
        _uses.SelectMany(user => user.Value.Select(used => (user.Key, used.Key, used.Value)));

    /// <summary>The shortest way from each namespace back to itself, each cycle once: "A -> B (by type) -> A (by type)".</summary>
    public IReadOnlyList<string> Cycles()
    {
        SortedDictionary<string, string> cycles = new(StringComparer.Ordinal);
        foreach (string start in _uses.Keys)
        {
            if (ShortestCycle(start) is { } cycle)
            {
                string key = string.Join(' ', cycle.SkipLast(1).Order(StringComparer.Ordinal));
                cycles.TryAdd(
                    key,
                    string.Join(" -> ", cycle.Select((name, index) => index == 0 ? name : $"{name} (by {_uses[cycle[index - 1]][name]})")));
            }
        }

        return [.. cycles.Values];
    }

    private List<string>? ShortestCycle(string start)
    {
        Dictionary<string, string> before = new(StringComparer.Ordinal);
        Queue<string> queue = new([start]);
        while (queue.TryDequeue(out string? current))
        {
            foreach (string next in _uses[current].Keys)
            {
                if (next == start)
                {
                    List<string> cycle = [start];
                    for (string step = current; step != start; step = before[step])
                    {
                        cycle.Insert(0, step);
                    }

                    cycle.Insert(0, start);
                    return cycle;
                }

                if (_uses.ContainsKey(next) && before.TryAdd(next, current))
                {
                    queue.Enqueue(next);
                }
            }
        }

        return null;
    }

    private void Add(Type type, Type used)
    {
        if (used.Namespace is not { } target || !_own.Contains(target) || target == type.Namespace)
        {
            return;
        }

        if (!_uses.TryGetValue(type.Namespace!, out SortedDictionary<string, string>? uses))
        {
            _uses[type.Namespace!] = uses = new SortedDictionary<string, string>(StringComparer.Ordinal);
        }

        uses.TryAdd(target, $"{Outermost(type).Name}'s {used.Name}");
    }

    private static Type Outermost(Type type) => type.DeclaringType is { } outer ? Outermost(outer) : type;

    /// <summary>A type with its element type and its type arguments.</summary>
    private static IEnumerable<Type> Parts(Type type)
    {
        if (type.HasElementType)
        {
            return Parts(type.GetElementType()!);
        }

        return type.IsGenericType && !type.IsGenericTypeDefinition
            ? [type.GetGenericTypeDefinition(), .. type.GetGenericArguments().SelectMany(Parts)]
            : [type];
    }

    private static IEnumerable<Type> UsedBy(Type type) =>
    [
        .. type.BaseType is { } parent ? [parent] : Type.EmptyTypes,
        .. type.GetInterfaces(),
        .. type.GetCustomAttributesData().Select(attribute => attribute.AttributeType),
        .. type.GetGenericArguments().Where(argument => argument.IsGenericParameter).SelectMany(
            argument => argument.GetGenericParameterConstraints()),
        .. type.GetFields(All).Select(field => field.FieldType),
        .. type.GetConstructors(All).SelectMany(UsedBySignature),
        .. type.GetMethods(All).SelectMany(UsedBySignature),
        .. type.GetConstructors(All).SelectMany(UsedByBody),
        .. type.GetMethods(All).SelectMany(UsedByBody),
    ];

    private static IEnumerable<Type> UsedBySignature(MethodBase method) =>
    [
        .. method.GetParameters().Select(parameter => parameter.ParameterType),
        .. method is MethodInfo { ReturnType: var result } ? [result] : Type.EmptyTypes,
        .. method.IsGenericMethod ? method.GetGenericArguments().Where(argument => !argument.IsGenericParameter) : [],
    ];

    private static IEnumerable<Type> UsedByBody(MethodBase method)
    {
        if (method.GetMethodBody() is not { } body)
        {
            return [];
        }

        Type[] ofType = method.DeclaringType!.IsGenericType ? method.DeclaringType.GetGenericArguments() : [];
        Type[] ofMethod = method.IsGenericMethod ? method.GetGenericArguments() : [];
        return
        [
            .. body.LocalVariables.Select(local => local.LocalType),
            .. body.ExceptionHandlingClauses.Where(
                clause => clause.Flags == ExceptionHandlingClauseOptions.Clause && clause.CatchType is not null)
                .Select(clause => clause.CatchType!),
            .. Tokens(body.GetILAsByteArray()!).SelectMany(token => UsedBy(method.Module.ResolveMember(token, ofType, ofMethod)!)),
        ];
    }

    private static IEnumerable<Type> UsedBy(MemberInfo member) => member switch
    {
        Type type => [type],
        FieldInfo field => [field.DeclaringType!, field.FieldType],
        MethodBase method => [method.DeclaringType!, .. UsedBySignature(method)],
        _ => [],
    };

    /// <summary>The types, fields and methods that instructions name.</summary>
    private static List<int> Tokens(byte[] code)
    {
        List<int> tokens = [];
        for (int at = 0; at < code.Length;)
        {
            short value = code[at++];
            if (value == 0xFE)
            {
                value = unchecked((short)(0xFE00 | code[at++]));
            }

            OpCode instruction = OpCodesByValue[value];
            if (instruction.OperandType
                is OperandType.InlineField or OperandType.InlineMethod or OperandType.InlineTok or OperandType.InlineType)
            {
                tokens.Add(BitConverter.ToInt32(code, at));
            }

            at += instruction.OperandType switch
            {
                OperandType.InlineNone => 0,
                OperandType.ShortInlineBrTarget or OperandType.ShortInlineI or OperandType.ShortInlineVar => 1,
                OperandType.InlineVar => 2,
                OperandType.InlineI8 or OperandType.InlineR => 8,
                OperandType.InlineSwitch => 4 + (4 * BitConverter.ToInt32(code, at)),
                _ => 4,
            };
        }

        return tokens;
    }
}
